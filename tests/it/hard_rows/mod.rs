//! The hard cases beside the 82 of `kernels::hard_cases`: what is hard about leaving surfaces, optics, recursion and bad
//! input. A test begins with the name of its row.
//!
//! | row | test | what it holds |
//! |---|---|---|
//! | E01-E04 | `spawn::e01_` to `e04_` | rays leave a plane at 1, 100, 10^4, 10^6 from the origin |
//! | E05-E08 | `spawn::e05_` to `e08_` | rays leave a sphere there |
//! | E09 | `spawn::e09_contact_shadows_at_any_gap`, `e09_a_card_on_the_floor_shadows_it` | contact shadows |
//! | E10 | `spawn::e10_` | the point of contact itself |
//! | E11 | `spawn::e11_` | grazing light |
//! | E12, E13 | `spawn::e12_`, `e13_` | a hundred reflections between mirrors, bit for bit |
//! | E14 | `spawn::e14_` | a corner of mirrors |
//! | E15 | `spawn::e15_` | a closed cube of mirrors |
//! | E16 | `spawn::e16_` | a whispering gallery |
//! | E17 | `spawn::e17_` | a glass ball |
//! | E18 | `seams::e18_` | shadow rays over a seam |
//! | E19, E20 | `seams::e19_`, `e20_` | ties |
//! | F01-F08 | `optics::f01_` to `f08_` | next to the critical angle; the many are in `kernels::optics` |
//! | F09, F10 | `optics::f09_`, `f10_` | directions that stay as they are |
//! | F11-F15 | `optics::f11_` to `f15_` | Fresnel's equations |
//! | F16, F17 | `optics::f16_`, `f17_` (two) | shares of light |
//! | F18 | `optics::f18_` | a parallel slab |
//! | F19 | `optics::f19_` | no NaN at total reflection |
//! | G01-G08 | `recursion::g01_` to `g08_` | depth, weights, lights |
//! | G09 | `recursion::g09_`; every committed scene: `effects` | nothing that nobody asked for |
//! | G10 | `recursion::g10_`; every committed scene: `bits` | the same bytes |
//! | H01-H06 | `bad_input::h01_` to `h06_`; the wording: `crate::bad_input` | what is refused |
//!
//! [`leaks`] holds closed meshes and squares of many triangles against rays at their seams.
//!
//! Three rows hold in another form than they were first put. E17: a ray through the middle of a ball comes out bit for bit
//! where the stored normal is parallel to it; elsewhere to 2 ulp. F17: `R + T = 1` is to an ulp where T is `1 - R`; by an
//! equation of its own it is to 8. F18: see there.

mod bad_input;
mod leaks;
mod optics;
mod recursion;
mod seams;
mod spawn;
