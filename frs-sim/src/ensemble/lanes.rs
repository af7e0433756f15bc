//! One lane of states and tangents.

use frs_core::lanes::Lane;
use frs_core::spatial::Pose;

use crate::integrate::{State, Tangent};

/// The state in a lane.
pub fn state<T: Lane<Element = f64>>(of: &State<T>, lane: usize) -> State {
    let number = |number: T| number.lane(lane);
    let Pose { rotation, translation } = of.pose;
    State {
        pose: Pose::new(rotation.map(number), translation.map(number)),
        flat: of.flat.iter().map(|number| number.lane(lane)).collect(),
    }
}

/// Puts a state into a lane.
pub fn set_state<T: Lane<Element = f64>>(to: &mut State<T>, lane: usize, state: &State) {
    let State { pose, flat } = to;
    let numbers = pose.rotation.iter_mut().chain(&mut pose.translation).chain(flat);
    let given = state.pose.rotation.iter().chain(&state.pose.translation).chain(&state.flat);
    numbers.zip(given).for_each(|(number, &given)| number.set_lane(lane, given));
}

/// Copies a state from lane to lane.
pub fn copy_state<T: Lane>(to: &mut State<T>, from: &State<T>, lane: usize) {
    let State { pose, flat } = to;
    let numbers = pose.rotation.iter_mut().chain(&mut pose.translation).chain(flat);
    let others = from.pose.rotation.iter().chain(&from.pose.translation).chain(&from.flat);
    numbers.zip(others).for_each(|(number, other)| number.set_lane(lane, other.lane(lane)));
}

/// Copies a tangent from lane to lane.
pub fn copy_tangent<T: Lane>(to: &mut Tangent<T>, from: &Tangent<T>, lane: usize) {
    let Tangent { twist, flat } = to;
    let numbers = twist.angular.iter_mut().chain(&mut twist.linear).chain(flat);
    let others = from.twist.angular.iter().chain(&from.twist.linear).chain(&from.flat);
    numbers.zip(others).for_each(|(number, other)| number.set_lane(lane, other.lane(lane)));
}
