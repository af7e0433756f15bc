//! `frs explain`: what a scene computes, and why.

mod count;

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use comfy_table::{Table, presets};
use frs::Model;
use frs_sim::observer::Observer;
use frs_sim::scene::{Case, Force, Scene};

pub use self::count::Costs;
use super::scene::{self, Loaded};
use super::{Failure, table};

/// Tell what a scene computes: its effects, what is known about the momentum, the equations that remain, and their cost.
#[derive(Args)]
#[command(after_help = "Exit codes: 0 ok, 2 bad input.")]
pub struct Explain {
    /// The scene (docs/scenes.md).
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,
}

impl Explain {
    pub fn run(self) -> Result<(), Failure> {
        let Loaded { scene, model, .. } = scene::load(&self.scene)?;
        let mut out = io::stdout().lock();
        table::robot(&mut out, &model)?;
        let costs = Costs::of(&scene, &model);
        effects(&mut out, &scene, &costs)?;
        momentum(&mut out, &scene)?;
        state(&mut out, &scene, &model)?;
        writeln!(out, "\nEquations\n{}", equations(&scene))?;
        observer(&mut out, &scene)?;
        writeln!(
            out,
            "\nOne evaluation of them\n  as the simulator computes them: {}\n  without what is constant here or not used: {}",
            costs.whole, costs.needed
        )?;
        Ok(left_out(&mut out, &scene)?)
    }
}

/// More times than this are told by the first and the last.
const MANY: usize = 12;

fn effects(out: &mut impl Write, scene: &Scene, costs: &Costs) -> io::Result<()> {
    if scene.forces.is_empty() {
        return writeln!(out, "Effects\n  none: the robot floats, and nothing acts on its joints");
    }
    let mut rows = Table::new();
    rows.load_preset(presets::NOTHING);
    for (named, cost) in scene.forces.iter().zip(&costs.effects) {
        let (key, line) = (named.force.key(), named.line);
        let cost = cost.map_or("part of the equations".to_owned(), |cost| cost.to_string());
        rows.add_row([&format!("  [{key}], line {line}"), named.force.equation(), &cost]);
    }
    writeln!(out, "Effects\n{rows}")?;
    for named in &scene.forces {
        let knots = named.force.knots();
        if !knots.is_empty() {
            let times: Vec<String> = knots.iter().map(f64::to_string).collect();
            let times = match times.as_slice() {
                [first, .., last] if times.len() > MANY => format!("{} times from {first} to {last}", times.len()),
                _ => times.join(", "),
            };
            let (key, line) = (named.force.key(), named.line);
            writeln!(out, "  [{key}], line {line}: the steps meet {times} s exactly")?;
        }
        if matches!(named.force, Force::Stops { .. } | Force::Contact(_)) {
            let (key, line) = (named.force.key(), named.line);
            writeln!(out, "  [{key}], line {line}: the steps meet the instants of touching and leaving")?;
        }
    }
    Ok(())
}

fn momentum(out: &mut impl Write, scene: &Scene) -> io::Result<()> {
    let case = scene.case();
    let falls = |force: &Force| matches!(force, Force::Gravity(_));
    let drives = |force: &Force| force.drives_momentum() || falls(force);
    let driving: Vec<_> = scene.forces.iter().filter(|named| drives(&named.force)).collect();
    let why = match case {
        Case::Driven | Case::Hamel if case != scene.known_case() => {
            let known = scene.known_case().name();
            format!("it is {known}, but [solver] integrates it all the same")
        }
        Case::Driven | Case::Hamel => {
            let named: Vec<_> = driving.iter().map(|n| format!("[{}] in line {}", n.force.key(), n.line)).collect();
            format!("{} can change it", named.join(", "))
        }
        Case::Ballistic => {
            "gravity alone changes it, and not about the centre of mass, which falls on a parabola".into()
        }
        Case::Conserved if !scene.handovers().is_empty() => {
            "no force can change it, but a payload brings or takes some".into()
        }
        Case::Conserved => "no effect can change it, and at the start it is not zero".into(),
        Case::Zero => "no effect can change it, and at the start it is zero".into(),
    };
    writeln!(out, "\nMomentum: {}\n  {why}", case.name())
}

fn state(out: &mut impl Write, scene: &Scene, model: &Model) -> io::Result<()> {
    let (n, case) = (model.dof(), scene.case());
    let mu = match case {
        Case::Driven => "6 for μ".to_owned(),
        Case::Hamel => "6 for V₁".to_owned(),
        Case::Conserved | Case::Ballistic => "none for μ, which follows from the momentum".to_owned(),
        Case::Zero => "none for μ, which is 0".to_owned(),
    };
    let numbers = 2 * n + case.numbers();
    let works: Vec<String> = scene.works().into_iter().map(|work| work.name).collect();
    let measured = if works.is_empty() { "nothing, for nothing does work".into() } else { works.join(", ") };
    writeln!(
        out,
        "\nState: the pose of the base and {numbers} numbers\n  {n} for q, {n} for q̇, {mu}\n  measured on the way, unseen by the steps, is the work of {measured}"
    )
}

fn observer(out: &mut impl Write, scene: &Scene) -> io::Result<()> {
    let Some(Observer { gain, .. }) = scene.observer else { return Ok(()) };
    writeln!(
        out,
        "\nObserver of μ, k = {gain} 1/s: reads g₁, q, q̇ and F₁, not V₁ nor μ\n  \
         φ = log(R̂ᵀ R₁),  d = c − ĉ,  ω̂ = z_ω + k φ,  v̂ = z_v + k d\n  \
         J ż_ω = n + (J ω̂) × Ω̂ − J̇ ω̂ + k² J φ,  ż_v = f/m + a + k² d,  R̂ and ĉ follow\n  \
         a pose and 6 numbers, in steps of their own: the motion does not notice\n  \
         V = ½ (μ̂ − μ)ᵀ Λ_b (μ̂ − μ) falls at the rate 2 k, but for what the turning inertia adds"
    )
}

/// The equations of motion that are left.
fn equations(scene: &Scene) -> String {
    let any = |of: fn(&Force) -> bool| scene.forces.iter().any(|named| of(&named.force));
    let inertia = if any(|force| matches!(force, Force::Rotors(_))) { "(Λ_q + J)" } else { "Λ_q" };
    let (shape, momentum) = match scene.case() {
        Case::Hamel => return "  M [V̇₁; q̈] + C(q, V) V = [F₁; τ],  V = [V₁; q̇]\n  ġ₁ = g₁ V₁^".into(),
        Case::Zero => ("τ − Γ'_q(q̇) q̇", "ġ₁ = g₁ (−A_l q̇)^"),
        Case::Conserved => (
            "τ − Γ'_q(q̇) q̇ + c(μ) − 2 B_2(μ) q̇",
            "Λ_c μ_c = R₁ᵀ h,  h constant (about the centre of mass)\n  ġ₁ = g₁ (μ − A_l q̇)^",
        ),
        Case::Ballistic => (
            "τ − Γ'_q(q̇) q̇ + c(μ) − 2 B_2(μ) q̇",
            "Λ_c μ_c = R₁ᵀ (h + [0; m a t]),  h constant (about the centre of mass)\n  ġ₁ = g₁ (μ − A_l q̇)^",
        ),
        Case::Driven => (
            "τ − A_lᵀ F₁ − Γ'_q(q̇) q̇ + c(μ) − 2 B_2(μ) q̇",
            "Λ_b μ̇ = F₁ + ad_{V₁}ᵀ Λ_b μ − P(q̇) μ\n  ġ₁ = g₁ V₁^,  V₁ = μ − A_l q̇",
        ),
    };
    let given = if any(|force| matches!(force, Force::Prescribed(..))) {
        "\n  for joints on a course τ is what this takes, for the others q̈"
    } else {
        ""
    };
    let water = if any(|force| matches!(force, Force::AddedMass(..))) {
        "\n  (Λ + Σ Jᵀ M_A J) ξ̇ = f + Σ Jᵀ (ad_Vᵀ M_A V − M_A V̇⁰) gives the water's wrenches, f all that is above, J = [X_k J̃_k]"
    } else {
        ""
    };
    format!("  {inertia} q̈ = {shape}{given}\n  {momentum}{water}")
}

fn left_out(out: &mut impl Write, scene: &Scene) -> io::Result<()> {
    writeln!(out, "\nLeft out")?;
    let named: Vec<&str> = scene.forces.iter().map(|named| named.force.key()).collect();
    let absent: Vec<&str> = frs_sim::scene::EFFECTS.into_iter().filter(|key| !named.contains(key)).collect();
    if !absent.is_empty() {
        writeln!(out, "  effects that the scene does not name: {}", absent.join(", "))?;
    }
    match scene.case() {
        Case::Zero => writeln!(out, "  all terms with μ, and the equation of μ"),
        Case::Conserved | Case::Ballistic => writeln!(out, "  the equation of μ"),
        Case::Driven | Case::Hamel => writeln!(out, "  nothing of the equations"),
    }
}
