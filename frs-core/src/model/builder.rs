//! From a description to a model: the phases, in order.
//!
//! Each phase reports what it finds and goes on as far as its findings allow, so that one run tells all problems.

mod axis;
mod definite;
mod determined;
mod lower;
mod mimic;
mod names;
mod numbers;
mod tree;
mod wording;

use lower::Lowered;

use super::{Model, ModelError, Problem, RobotDescription, Severity};

/// Checks `robot` and makes its model; warnings travel with the model.
pub(super) fn build(robot: &RobotDescription) -> Result<Model, ModelError> {
    let mut problems: Vec<Problem> = Vec::new();
    numbers::check(robot, &mut problems);
    let names = names::resolve(robot, &mut problems);
    let followings = mimic::compose(robot, &names, &mut problems);
    let tree = tree::grow(robot, &names, &mut problems);
    if let Some(tree) = &tree {
        determined::check(robot, tree, &followings, &mut problems);
    }
    let stops = |problems: &[Problem]| problems.iter().any(|problem| problem.severity == Severity::Error);
    let Some(tree) = tree.filter(|_| !stops(&problems)) else {
        return Err(ModelError::new(problems));
    };
    let Lowered { model, joints } = lower::lower(robot, &tree, &followings);
    definite::check(robot, &model, &joints, &mut problems);
    if stops(&problems) { Err(ModelError::new(problems)) } else { Ok(model.with_warnings(problems)) }
}
