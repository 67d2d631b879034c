//! What stands behind the question mark of an address.

use super::answer::Refusal;
use crate::input::one_of;
use crate::scene::Resolution;

/// The names and values of a query, decoded.
#[derive(Debug)]
pub(super) struct Query(Vec<(String, String)>);

impl Query {
    /// The query of a request that knows these names.
    ///
    /// # Errors
    /// [`Refusal`] for a name that is none of them.
    pub(super) fn parse(text: Option<&str>, known: &[&str]) -> Result<Self, Refusal> {
        let pairs = form_urlencoded::parse(text.unwrap_or_default().as_bytes());
        let pairs: Vec<(String, String)> = pairs.map(|(name, value)| (name.into_owned(), value.into_owned())).collect();
        match pairs.iter().all(|(name, _)| known.contains(&name.as_str())) {
            true => Ok(Self(pairs)),
            false => Err(Refusal::bad(
                format!("the query has a name besides {}", one_of(known.iter().copied())),
                "those alone",
            )),
        }
    }

    /// All values of a name.
    pub(super) fn all(&self, name: &str) -> impl Iterator<Item = &str> {
        self.0.iter().filter(move |(known, _)| known == name).map(|(_, value)| value.as_str())
    }

    /// The value of a name that stands there once at most.
    ///
    /// # Errors
    /// [`Refusal`] where it stands there twice.
    pub(super) fn one(&self, name: &str) -> Result<Option<&str>, Refusal> {
        let mut values = self.all(name);
        match (values.next(), values.next()) {
            (_, Some(_)) => Err(Refusal::bad("the query has a name twice", "once each")),
            (value, None) => Ok(value),
        }
    }

    /// A number from 0.
    ///
    /// # Errors
    /// [`Refusal`] for anything else.
    pub(super) fn number(&self, name: &str) -> Result<Option<u32>, Refusal> {
        let number = |text: &str| {
            // Digits alone: the parser would take a plus sign.
            let digits = text.bytes().all(|byte| byte.is_ascii_digit());
            text.parse()
                .ok()
                .filter(|_| digits)
                .ok_or_else(|| Refusal::bad("not a number where one belongs", "digits alone"))
        };
        self.one(name)?.map(number).transpose()
    }

    /// The pixel `x`, `y` of an image.
    ///
    /// # Errors
    /// [`Refusal`] where one is missing, is no number, or lies outside.
    pub(super) fn pixel(&self, image: Resolution) -> Result<[u32; 2], Refusal> {
        let help = "x and y, from 0 at the top left";
        let (Some(x), Some(y)) = (self.number("x")?, self.number("y")?) else {
            return Err(Refusal::bad("no pixel is named", help));
        };
        inside(image, [x, y]).ok_or_else(|| Refusal::bad("the pixel lies outside the image", help))
    }
}

/// The pixel, if it lies in the image.
pub(super) fn inside(image: Resolution, [x, y]: [u32; 2]) -> Option<[u32; 2]> {
    (x < image.width && y < image.height).then_some([x, y])
}
