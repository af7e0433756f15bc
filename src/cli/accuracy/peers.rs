//! Other programs on the same scene, for comparison: MuJoCo and Pinocchio, where a Python has them.

use std::io::{self, BufRead, BufReader, Write};
use std::process::{Command, Stdio};

use comfy_table::{Table, presets};
use frs::nalgebra::{Matrix3, Vector3};
use frs::spatial::Pose;
use frs::{Model, Workspace};
use frs_sim::effects::{Axes, Decoupling};
use frs_sim::scene::{Force, Scene};
use frs_sim::signal::Signal;
use frs_sim::study::Truth;
use indicatif::ProgressBar;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::advice::{ASKED, time};
use super::picture::SEEN;
use crate::cli::Failure;

/// What other programs gave.
#[derive(Default)]
pub struct Peers {
    pub motions: Vec<Motion>,
    /// Why a program has none.
    pub left_out: Vec<String>,
}

/// One motion of another program; motions of one method follow each other, coarse to fine.
pub struct Motion {
    pub program: String,
    pub method: String,
    /// The longest step, s.
    pub step: f64,
    pub evaluations: usize,
    /// How long it took, s, without what Python did.
    pub seconds: f64,
    /// Of pose and shape.
    pub error: f64,
}

/// What other programs are told. Twists and wrenches have their angular half first.
#[derive(Serialize)]
struct Request<'a> {
    urdf: &'a str,
    joints: Vec<&'a str>,
    position: [f64; 3],
    rotation: [[f64; 3]; 3],
    /// Of the base, in its axes.
    twist: [f64; 6],
    q: &'a [f64],
    qd: &'a [f64],
    times: &'a [f64],
    gravity: [f64; 3],
    stiffness: Vec<f64>,
    rest: Vec<f64>,
    damping: Vec<f64>,
    /// Whether the (μ, μ) coupling torque is cancelled.
    decoupling: bool,
    pieces: Vec<Piece>,
}

/// What acts and does not change until some time.
#[derive(Serialize)]
struct Piece {
    until: f64,
    tau: Vec<f64>,
    /// On the base, in its axes and in the world's.
    base: [f64; 6],
    world: [f64; 6],
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Reply {
    LeftOut { left_out: String },
    Motion { program: String, method: String, step: f64, evaluations: usize, seconds: f64, states: Vec<Told> },
}

#[derive(Deserialize)]
struct Told {
    position: [f64; 3],
    rotation: [[f64; 3]; 3],
    q: Vec<f64>,
}

impl Peers {
    /// Asks the programs that `python` has.
    pub fn of(
        python: &str,
        scene: &Scene,
        model: &Model,
        urdf: &str,
        truth: &Truth,
        bar: &ProgressBar,
    ) -> Result<Self, Failure> {
        let request = match Request::of(scene, model, urdf, truth.times()) {
            Ok(request) => request,
            Err(unknown) => {
                let left_out = vec![format!("they do not know {unknown}")];
                return Ok(Self { motions: Vec::new(), left_out });
            }
        };
        let failed = |what: &str, error: &dyn std::fmt::Display| {
            let expected = "expected a Python with the packages mujoco, pin, or both";
            Failure::Input(format!("--peers: {python} {what}: {error}; {expected}"))
        };
        let mut command = Command::new(python);
        command.args(["-c", include_str!("peers.py")]).env("OMP_NUM_THREADS", "1").env("OPENBLAS_NUM_THREADS", "1");
        let spawned = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
        let mut child = spawned.map_err(|error| failed("cannot be started", &error))?;
        let text = serde_json::to_string(&request).map_err(|error| Failure::Input(error.to_string()))?;
        if let Some(mut stdin) = child.stdin.take() {
            // A program that ends without reading tells why by its exit code.
            let _ = stdin.write_all(text.as_bytes());
        }
        let mut peers = Self::default();
        for line in child.stdout.take().into_iter().flat_map(|out| BufReader::new(out).lines()) {
            let line = line.map_err(|error| failed("cannot be heard", &error))?;
            match serde_json::from_str(&line).map_err(|error| failed("says what is no answer", &error))? {
                Reply::LeftOut { left_out } => peers.left_out.push(left_out),
                Reply::Motion { program, method, step, evaluations, seconds, states } => {
                    bar.set_message(format!("{program}, {method}"));
                    bar.tick();
                    let places: Vec<_> = states.iter().map(Told::place).collect();
                    let error = truth.judge_places(&places).of_state();
                    peers.motions.push(Motion { program, method, step, evaluations, seconds, error });
                }
            }
        }
        let output = child.wait_with_output().map_err(|error| failed("cannot be heard", &error))?;
        if !output.status.success() {
            let said = String::from_utf8_lossy(&output.stderr);
            return Err(failed("failed", &said.lines().last().unwrap_or("no message")));
        }
        Ok(peers)
    }

    /// Motions by program and method.
    pub fn curves(&self) -> impl Iterator<Item = &[Motion]> {
        self.motions.chunk_by(|a, b| (&a.program, &a.method) == (&b.program, &b.method))
    }

    /// What each method takes for the accuracies that are asked for, as a table for people.
    pub fn print(&self, out: &mut impl Write, duration: f64) -> io::Result<()> {
        if self.motions.is_empty() {
            return Ok(());
        }
        let mut rows = Table::new();
        rows.load_preset(presets::NOTHING);
        rows.add_row(["for", "by", "step", "its error", "it costs"]);
        for want in ASKED {
            for curve in self.curves() {
                let enough = curve.iter().filter(|motion| motion.error <= want);
                let Some(motion) = enough.min_by(|a, b| a.seconds.total_cmp(&b.seconds)) else { continue };
                rows.add_row([
                    format!("{want:.0e}"),
                    motion.name(),
                    time(motion.step),
                    format!("{:.1e}", motion.error),
                    format!("{} a simulated second", time(motion.seconds / duration)),
                ]);
            }
        }
        writeln!(out, "\n{rows}")
    }

    /// All motions for programs.
    pub fn json(&self) -> Value {
        let motion = |motion: &Motion| {
            let Motion { program, method, step, error, evaluations, seconds } = motion;
            json!({ "program": program, "method": method, "step": step, "error": error, "evaluations": evaluations, "seconds": seconds })
        };
        json!({ "motions": self.motions.iter().map(motion).collect::<Vec<_>>(), "left_out": self.left_out })
    }

    /// All motions as comma-separated values.
    pub fn csv(&self) -> String {
        let head = "program,method,step,error,evaluations,seconds\n".to_owned();
        self.motions.iter().fold(head, |text, motion| {
            let Motion { program, method, step, error, evaluations, seconds } = motion;
            text + &format!("{program},{method},{step:e},{error:e},{evaluations},{seconds:e}\n")
        })
    }
}

impl Motion {
    /// The program and its method.
    pub fn name(&self) -> String {
        format!("{} {}", self.program, self.method)
    }

    /// Whether it is near enough to the scene's motion to be drawn.
    pub fn is_seen(self: &&Self) -> bool {
        SEEN.contains(&self.error)
    }
}

impl Told {
    fn place(&self) -> (Pose<f64>, Vec<f64>) {
        let rotation = Matrix3::from_fn(|row, column| self.rotation[row][column]);
        (Pose::new(rotation, Vector3::from(self.position)), self.q.clone())
    }
}

impl<'a> Request<'a> {
    /// What acts in words that other programs have, or the effect for which they have none.
    fn of(scene: &'a Scene, model: &'a Model, urdf: &'a str, times: &'a [f64]) -> Result<Self, String> {
        let n = model.dof();
        let start = &scene.start;
        let mut knots: Vec<f64> = scene.forces.iter().flat_map(|named| named.force.knots()).collect();
        knots.retain(|time| *time > 0.0 && *time < scene.duration);
        knots.push(scene.duration);
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        let rotation = start.pose.rotation;
        let mut request = Self {
            urdf,
            joints: model.coordinates().iter().map(|coordinate| coordinate.name.as_str()).collect(),
            position: start.pose.translation.into(),
            rotation: std::array::from_fn(|row| std::array::from_fn(|column| rotation[(row, column)])),
            twist: Workspace::new(model).shape(&start.q).moving(&start.qd).base_twist(start.mu).to_array(),
            q: &start.q,
            qd: &start.qd,
            times,
            gravity: [0.0; 3],
            stiffness: vec![0.0; n],
            rest: vec![0.0; n],
            damping: vec![0.0; n],
            decoupling: false,
            pieces: knots.iter().map(|&until| Piece::free(until, n)).collect(),
        };
        for named in &scene.forces {
            request.add(&named.force).map_err(|what| format!("{what} (line {})", named.line))?;
        }
        Ok(request)
    }

    fn add(&mut self, force: &Force) -> Result<(), String> {
        match force {
            Force::Gravity(gravity) => self.gravity = gravity.acceleration,
            Force::Spring(spring) => self.hold(&spring.stiffness, &spring.rest),
            Force::Viscous(friction) => self.damp(&friction.damping),
            Force::Regulator(gains) if gains.decoupling != Decoupling::TauBar => {
                self.hold(&gains.stiffness, &gains.set_point);
                self.damp(&gains.damping);
                self.decoupling |= gains.decoupling == Decoupling::Coupling;
            }
            Force::JointTorque(torque) => {
                for (i, signal) in torque.tau.iter().enumerate() {
                    self.push(signal, |piece| &mut piece.tau[i])?;
                }
            }
            Force::Wrench(wrench) if wrench.link.is_none() && wrench.point == [0.0; 3] => {
                for (i, signal) in wrench.wrench.iter().enumerate() {
                    self.push(signal, |piece| match wrench.axes {
                        Axes::Link => &mut piece.base[i],
                        Axes::World => &mut piece.world[i],
                    })?;
                }
            }
            Force::Wrench(_) => return Err("a wrench elsewhere than in the base's origin".into()),
            Force::Regulator(_) => return Err("the regulator's older decoupling".into()),
            other => return Err(other.key().into()),
        }
        Ok(())
    }

    /// One more spring in each joint: two are one, between them.
    fn hold(&mut self, stiffness: &[f64], rest: &[f64]) {
        for (j, (&k, &r)) in stiffness.iter().zip(rest).enumerate().filter(|(_, (k, _))| **k != 0.0) {
            let whole = self.stiffness[j] + k;
            self.rest[j] = (self.stiffness[j] * self.rest[j] + k * r) / whole;
            self.stiffness[j] = whole;
        }
    }

    fn damp(&mut self, damping: &[f64]) {
        self.damping.iter_mut().zip(damping).for_each(|(whole, own)| *whole += own);
    }

    /// Adds what a signal is in each piece, where it must not change.
    fn push(&mut self, signal: &Signal, of: impl Fn(&mut Piece) -> &mut f64) -> Result<(), String> {
        let (mut signal, mut begin) = (signal.clone(), 0.0);
        for piece in &mut self.pieces {
            signal.enter(begin);
            let [value, rate, bend] = signal.with_rates(0.5 * (begin + piece.until));
            if (rate, bend) != (0.0, 0.0) {
                return Err("a course between points of a table".into());
            }
            *of(piece) += value;
            begin = piece.until;
        }
        Ok(())
    }
}

impl Piece {
    fn free(until: f64, n: usize) -> Self {
        Self { until, tau: vec![0.0; n], base: [0.0; 6], world: [0.0; 6] }
    }
}
