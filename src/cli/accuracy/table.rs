//! All points as comma-separated values.

use frs_sim::integrate::Steps;

use super::search::Search;

const HEAD: &str = "method,pace,equations,route,scalar,evaluation,accuracy,step,error_pose,error_shape,error_momentum,\
                    error_energy,evaluations,operations,seconds,seconds_least,seconds_most,runs,on_front\n";

/// A line a point; seconds are those of the whole motion, the middle of all runs.
pub fn csv(search: &Search) -> String {
    let mut text = HEAD.to_owned();
    for (i, point) in search.points.iter().enumerate() {
        let steps = match point.variant.solver.steps {
            Steps::Accuracy(accuracy) => format!("{accuracy:e},"),
            Steps::Length(step) => format!(",{step:e}"),
        };
        let errors = point.errors;
        let [least, most] = point.spread();
        text += &format!(
            "{},{steps},{:e},{:e},{:e},{:e},{},{},{:e},{least:e},{most:e},{},{}\n",
            point.variant.names().join(","),
            errors.pose,
            errors.shape,
            errors.momentum,
            errors.energy,
            point.evaluations,
            point.operations,
            point.seconds(),
            point.runs.len(),
            u8::from(search.front.contains(&i)),
        );
    }
    text
}
