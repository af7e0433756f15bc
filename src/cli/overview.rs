//! `frs` alone: the default robot, what its equations look like, whether they hold, and the paper's example.

use std::io::{self, Write};

use comfy_table::{Table, presets};
use frs::nalgebra::{DMatrix, Matrix6xX};
use frs::spatial::Twist;
use frs::{Curvature, Model, Workspace, identities};

use super::{Failure, example, table};

/// States on which the identities are checked.
const STATES: usize = 1000;

/// A pose with no symmetry, so that no entry is zero by accident (rad).
const POSE: [f64; 7] = [0.3, -0.8, 0.5, 1.2, -0.4, 0.9, 0.2];

/// The locked velocity of the paper's example: turning about the base's y axis at 12 °/s (rad/s).
const LOCKED_TURN: f64 = 12.0 * std::f64::consts::PI / 180.0;

pub fn run() -> Result<(), Failure> {
    let model = Model::from_urdf(frs::urdf::LWR_SATELLITE).map_err(|error| Failure::Input(error.to_string()))?;
    let mut out = io::stdout().lock();
    show(&mut out, &model)?;
    out.flush()?;

    let residuals = identities::check(&model, STATES, 1);
    let mut rows = Table::new();
    rows.load_preset(presets::NOTHING).set_header(["identity", "worst residual", ""]);
    let mut broken = 0;
    for residual in &residuals {
        let holds = residual.worst <= identities::ROUNDING;
        broken += usize::from(!holds);
        rows.add_row([residual.identity, &format!("{:.1e}", residual.worst), if holds { "holds" } else { "BROKEN" }]);
    }
    writeln!(out, "{} identities on {STATES} random states (two formulas each, exact derivatives):", residuals.len())?;
    writeln!(out, "{rows}\n")?;
    if broken > 0 {
        return Err(Failure::Check(format!(
            "{broken} identities are broken: residual above {:e}",
            identities::ROUNDING
        )));
    }
    drop(out);
    example::run()?;
    let mut out = io::stdout().lock();
    writeln!(out, "Try next:")?;
    writeln!(out, "  frs eval ROBOT.urdf                         every quantity of your own robot at its zero pose")?;
    writeln!(out, "  frs eval ROBOT.urdf --states states.jsonl   the same at any states, as JSON lines")?;
    writeln!(out, "  frs eval --help                             the format of states, and all quantities")?;
    writeln!(out, "  frs verify ROBOT.urdf                       its generated code against the core, bit for bit")?;
    writeln!(out, "  frs simulate SCENE.toml --out FOLDER        a scene of your own (docs/scenes.md)")?;
    Ok(())
}

fn show(out: &mut impl Write, model: &Model) -> io::Result<()> {
    let n = model.dof();
    let mut work = Workspace::new(model);
    let mut shape = work.shape(&POSE);
    let (mut connection, mut shape_inertia) = (Matrix6xX::zeros(n), DMatrix::zeros(n, n));
    let mut curvature = Curvature::new(n);
    let mut torque = vec![0.0; n];
    let mu = Twist::from_array([0.0, LOCKED_TURN, 0.0, 0.0, 0.0, 0.0]);
    shape.connection(&mut connection);
    shape.shape_inertia(&mut shape_inertia);
    shape.curvature(&mut curvature);
    shape.coupling_torque(mu, &mut torque);

    table::robot(out, model)?;
    writeln!(out, "At q = {POSE:?} rad, in the base frame, angular part first:\n")?;
    writeln!(out, "Λ_b, the inertia with the joints locked (kg m², kg m, kg)")?;
    table::matrix(out, &shape.locked_inertia().to_matrix().resize(6, 6, 0.0))?;
    writeln!(out, "\nΛ_q, the inertia that the joints feel while the base floats (kg m²)")?;
    table::matrix(out, &shape_inertia)?;
    writeln!(out, "\nA_l, the mechanical connection: at zero momentum the base moves with −A_l q̇")?;
    table::matrix(out, &connection.resize_vertically(6, 0.0))?;
    writeln!(out, "\nCoupling torque while all turns at μ_ω = 12 °/s about y (N m)")?;
    table::matrix(out, &DMatrix::from_row_slice(1, n, &torque))?;
    writeln!(
        out,
        "\n𝓑_ω,y, the curvature: turn of the base about y per area of a small joint loop (i, j), sign reversed"
    )?;
    table::matrix(out, &curvature.angular[1])?;
    writeln!(out)
}
