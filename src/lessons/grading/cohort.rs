//! Many submissions: who has what, and what went wrong how often.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::{Grade, NO_SANDBOX, Verdict, indented};

/// What came of many submissions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cohort {
    /// `raytree-cohort/1`.
    pub format: String,
    /// That the grader is no sandbox.
    pub notice: String,
    /// The lessons' folders, in order.
    pub lessons: Vec<String>,
    /// The points there are in each.
    pub of: Vec<u32>,
    /// The submissions in the order of their names.
    pub submissions: Vec<Standing>,
    /// The known mistakes, the most frequent first.
    pub mistakes: Vec<MistakeCount>,
    /// What came of each stage.
    pub stages: Vec<StageCount>,
}

/// A submission among others.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Standing {
    /// Its name.
    pub submission: String,
    /// Its points.
    pub points: u32,
    /// Its points in each lesson.
    pub lessons: Vec<u32>,
    /// What there is to look at.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// A known mistake and those who made it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct MistakeCount {
    /// The lesson's folder.
    pub lesson: String,
    /// The function.
    pub function: String,
    /// The mistake's name for programs.
    pub id: String,
    /// What is wrong.
    pub name: String,
    /// Why it happens, or what it does.
    pub why: String,
    /// Who made it.
    pub submissions: Vec<String>,
}

/// What came of a stage, over all submissions.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct StageCount {
    /// The lesson's folder.
    pub lesson: String,
    /// The function.
    pub function: String,
    /// What it is about.
    pub name: String,
    /// How often each verdict was given.
    pub verdicts: BTreeMap<Verdict, usize>,
}

impl StageCount {
    /// How often a verdict was given.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.verdicts.get(&verdict).copied().unwrap_or_default()
    }
}

impl Cohort {
    /// What the grades come to. All have the same lessons.
    pub fn of(grades: &[Grade]) -> Self {
        let lessons = grades.first().map_or(&[][..], |grade| &grade.lessons);
        let mut mistakes: Vec<MistakeCount> = Vec::new();
        let mut stages: Vec<StageCount> = Vec::new();
        for (i, lesson) in lessons.iter().enumerate() {
            for (j, stage) in lesson.stages.iter().enumerate() {
                let mut verdicts = BTreeMap::new();
                for grade in grades {
                    let Some(stage) = grade.lessons.get(i).and_then(|lesson| lesson.stages.get(j)) else { continue };
                    *verdicts.entry(stage.verdict).or_default() += 1;
                    let Some(mistake) = stage.mistake() else { continue };
                    let is_same = |m: &&mut MistakeCount| m.lesson == lesson.folder && m.id == mistake.id;
                    match mistakes.iter_mut().find(is_same) {
                        Some(there) if there.submissions.contains(&grade.submission) => {}
                        Some(there) => there.submissions.push(grade.submission.clone()),
                        None => mistakes.push(MistakeCount {
                            lesson: lesson.folder.clone(),
                            function: stage.function.clone(),
                            id: mistake.id.clone(),
                            name: mistake.name.clone(),
                            why: mistake.why.clone(),
                            submissions: vec![grade.submission.clone()],
                        }),
                    }
                }
                let (function, name) = (stage.function.clone(), stage.name.clone());
                stages.push(StageCount { lesson: lesson.folder.clone(), function, name, verdicts });
            }
        }
        // Equal ones stay in the order of the lessons.
        mistakes.sort_by_key(|mistake| std::cmp::Reverse(mistake.submissions.len()));
        Cohort {
            format: "raytree-cohort/1".to_owned(),
            notice: NO_SANDBOX.to_owned(),
            lessons: lessons.iter().map(|lesson| lesson.folder.clone()).collect(),
            of: lessons.iter().map(|lesson| lesson.of).collect(),
            submissions: grades.iter().map(Standing::of).collect(),
            mistakes,
            stages,
        }
    }

    /// How often a verdict was given, over all stages.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.stages.iter().map(|stage| stage.count(verdict)).sum()
    }

    /// The whole model as JSON.
    pub fn to_json(&self) -> String {
        indented(self)
    }
}

impl Standing {
    fn of(grade: &Grade) -> Self {
        let noted = grade
            .lessons
            .iter()
            .flat_map(|lesson| lesson.notes.iter().map(move |note| format!("{}: {note}", lesson.folder)));
        Standing {
            submission: grade.submission.clone(),
            points: grade.points,
            lessons: grade.lessons.iter().map(|lesson| lesson.points).collect(),
            notes: grade.notes.iter().cloned().chain(noted).collect(),
        }
    }
}
