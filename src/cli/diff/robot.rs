//! What changed between two robots.

use std::collections::BTreeMap;

use frs::Model;
use frs::model::{InertialDescription, JointDescription, Limits, LinkDescription, RobotDescription};
use serde::Serialize;
use serde_json::{Value, json};

/// What changed, in links, joints, coordinates and numbers.
#[derive(Serialize)]
pub struct RobotChanges {
    /// The robots' names.
    pub names: [String; 2],
    /// Which links came and went.
    pub links: Set,
    /// Which joints came and went.
    pub joints: Set,
    /// Which coordinates came and went.
    pub coordinates: Set,
    /// Numbers on which the dynamics depend.
    pub parameters: Vec<Parameter>,
    /// Numbers on which they do not.
    pub without_effect: Vec<Parameter>,
    /// Old and new names of links, those that stay included.
    #[serde(skip)]
    pub renamed_links: BTreeMap<String, String>,
}

/// Names before and after.
#[derive(Default, Serialize)]
pub struct Set {
    /// How many there were, and are.
    pub counts: [usize; 2],
    /// Those that came.
    pub added: Vec<String>,
    /// Those that went.
    pub removed: Vec<String>,
    /// Those that have another name now.
    pub renamed: Vec<[String; 2]>,
    /// Whether those that stay stand in another order.
    pub reordered: bool,
}

/// Something that has another value now.
#[derive(Serialize)]
pub struct Parameter {
    /// Whose it is: `link 'hand'`, by its new name.
    pub of: String,
    /// What it is.
    pub name: &'static str,
    /// Its value before: a number, several, or a word.
    pub old: Value,
    /// Its value after.
    pub new: Value,
    /// How far it moved: (new − old) / |old| of a number, |new − old| / |old| of several; `None` where that says nothing.
    pub relative: Option<f64>,
}

impl RobotChanges {
    /// What changed from the first description and model to the second ones.
    pub fn new([old, new]: [&RobotDescription; 2], models: [&Model; 2]) -> Self {
        let links =
            matched(&old.links, &new.links, |link| &link.name, |before, after| same_link(old, before, new, after));
        let renamed_links = names(&links, |link| &link.name);
        let same_joint = |before: &JointDescription, after: &JointDescription| {
            let stays = |before: &String, after: &String| renamed_links.get(before) == Some(after);
            same_motion(before, after) && stays(&before.parent, &after.parent) && stays(&before.child, &after.child)
        };
        let joints = matched(&old.joints, &new.joints, |joint| &joint.name, same_joint);
        let renamed_joints = names(&joints, |joint| &joint.name);
        let mut changes = Changes::default();
        links.iter().for_each(|(before, after)| changes.link(before, after));
        joints.iter().for_each(|(before, after)| changes.joint(before, after, &renamed_links, &renamed_joints));
        let coordinates = models.map(|model| model.coordinates().iter().map(|c| c.name.clone()).collect::<Vec<_>>());
        let [links, joints] = [
            Set::new(
                [old, new].map(|robot| robot.links.iter().map(|link| link.name.clone()).collect()),
                &renamed_links,
            ),
            Set::new(
                [old, new].map(|robot| robot.joints.iter().map(|joint| joint.name.clone()).collect()),
                &renamed_joints,
            ),
        ];
        Self {
            names: [old, new].map(|robot| robot.name.clone()),
            links,
            joints,
            coordinates: Set::new(coordinates, &renamed_joints),
            parameters: changes.parameters,
            without_effect: changes.without_effect,
            renamed_links,
        }
    }
}

impl Set {
    fn new([old, new]: [Vec<String>; 2], renamed: &BTreeMap<String, String>) -> Self {
        // A coordinate may extend the name of its joint: planar joints have three.
        let becomes = |name: &String| match renamed.get(name) {
            Some(after) => Some(after.clone()),
            None => ["_x", "_y", "_yaw"]
                .into_iter()
                .find_map(|end| Some(renamed.get(name.strip_suffix(end)?)?.clone() + end)),
        };
        let pairs: Vec<(&String, String)> = old
            .iter()
            .filter_map(|before| becomes(before).filter(|after| new.contains(after)).map(|after| (before, after)))
            .collect();
        let places = |after: &String| new.iter().position(|name| name == after);
        Self {
            counts: [old.len(), new.len()],
            added: new.iter().filter(|name| pairs.iter().all(|(_, after)| after != *name)).cloned().collect(),
            removed: old.iter().filter(|name| pairs.iter().all(|(before, _)| before != name)).cloned().collect(),
            renamed: pairs
                .iter()
                .filter(|(before, after)| *before != after)
                .map(|(before, after)| [(*before).clone(), after.clone()])
                .collect(),
            reordered: !pairs.iter().map(|(_, after)| places(after)).is_sorted(),
        }
    }

    /// Whether all names are as before.
    pub fn is_same(&self) -> bool {
        self.added.is_empty() && self.removed.is_empty() && self.renamed.is_empty() && !self.reordered
    }
}

/// Pairs of the same: by name, and of what is left those that look the same.
fn matched<'a, T>(
    old: &'a [T],
    new: &'a [T],
    name: impl Fn(&T) -> &String,
    same: impl Fn(&T, &T) -> bool,
) -> Vec<(&'a T, &'a T)> {
    let mut pairs: Vec<(&T, &T)> = Vec::new();
    let (mut gone, mut come): (Vec<&T>, Vec<&T>) = (Vec::new(), new.iter().collect());
    for before in old {
        match come.iter().position(|after| name(after) == name(before)) {
            Some(place) => pairs.push((before, come.remove(place))),
            None => gone.push(before),
        }
    }
    for before in gone {
        if let Some(place) = come.iter().position(|after| same(before, after)) {
            pairs.push((before, come.remove(place)));
        }
    }
    pairs
}

fn names<'a, T>(pairs: &[(&'a T, &'a T)], name: impl Fn(&'a T) -> &'a String) -> BTreeMap<String, String> {
    pairs.iter().map(|(before, after)| (name(before).clone(), name(after).clone())).collect()
}

/// Whether two links of different names weigh the same and hang at the same place.
fn same_link(
    old: &RobotDescription,
    before: &LinkDescription,
    new: &RobotDescription,
    after: &LinkDescription,
) -> bool {
    let joint = |robot: &RobotDescription, link: &LinkDescription| {
        robot.joints.iter().find(|joint| joint.child == link.name).cloned()
    };
    before.inertial == after.inertial
        && match (joint(old, before), joint(new, after)) {
            (Some(before), Some(after)) => same_motion(&before, &after),
            (None, None) => true,
            _ => false,
        }
}

/// Whether two joints move in the same way.
fn same_motion(before: &JointDescription, after: &JointDescription) -> bool {
    let mimic = |joint: &JointDescription| joint.mimic.as_ref().map(|mimic| (mimic.multiplier, mimic.offset));
    before.kind == after.kind
        && before.origin == after.origin
        && before.axis == after.axis
        && mimic(before) == mimic(after)
}

#[derive(Default)]
struct Changes {
    parameters: Vec<Parameter>,
    without_effect: Vec<Parameter>,
}

impl Changes {
    fn link(&mut self, before: &LinkDescription, after: &LinkDescription) {
        let of = format!("link '{}'", after.name);
        let numbers = |inertial: &InertialDescription| {
            let (com, inertia) = (inertial.com, inertial.inertia);
            [
                ("mass (kg)", vec![inertial.mass]),
                ("centre of mass (m)", vec![com.x, com.y, com.z]),
                (
                    "inertia xx xy xz yy yz zz (kg·m²)",
                    vec![inertia.xx, inertia.xy, inertia.xz, inertia.yy, inertia.yz, inertia.zz],
                ),
            ]
        };
        for ((name, old), (_, new)) in numbers(&before.inertial).into_iter().zip(numbers(&after.inertial)) {
            self.parameters.extend(Parameter::of_numbers(&of, name, &old, &new));
        }
    }

    fn joint(
        &mut self,
        before: &JointDescription,
        after: &JointDescription,
        links: &BTreeMap<String, String>,
        joints: &BTreeMap<String, String>,
    ) {
        let of = format!("joint '{}'", after.name);
        let place = |joint: &JointDescription| joint.origin.translation.as_slice().to_vec();
        let turned = before.origin.rotation.transpose() * after.origin.rotation;
        let sine = [turned.m32 - turned.m23, turned.m13 - turned.m31, turned.m21 - turned.m12];
        let angle = norm(&sine).atan2(turned.trace() - 1.0);
        let axis = |joint: &JointDescription| joint.axis.try_normalize(0.0).unwrap_or_default().as_slice().to_vec();
        let mimic = |joint: &JointDescription| joint.mimic.as_ref().map_or(vec![], |m| vec![m.multiplier, m.offset]);
        let leader = |joint: &JointDescription| joint.mimic.as_ref().map(|mimic| mimic.joint.clone());
        let now = |name: &String, names: &BTreeMap<String, String>| names.get(name).unwrap_or(name).clone();

        let words = [
            ("kind", before.kind.to_string(), after.kind.to_string()),
            ("parent", now(&before.parent, links), after.parent.clone()),
            ("child", now(&before.child, links), after.child.clone()),
            (
                "follows",
                leader(before).map_or("nothing".into(), |name| now(&name, joints)),
                leader(after).unwrap_or("nothing".into()),
            ),
        ];
        for (name, old, new) in words.into_iter().filter(|(_, old, new)| old != new) {
            self.parameters.push(Parameter { of: of.clone(), name, old: old.into(), new: new.into(), relative: None });
        }
        self.parameters.extend(Parameter::of_numbers(&of, "origin (m)", &place(before), &place(after)));
        if before.origin.rotation != after.origin.rotation {
            self.parameters.extend(Parameter::of_numbers(&of, "origin, turned by (rad)", &[0.0], &[angle]));
        }
        // A fixed joint has an axis, but nothing turns about it.
        let list = if before.kind == after.kind && after.kind == frs::model::JointKind::Fixed {
            &mut self.without_effect
        } else {
            &mut self.parameters
        };
        list.extend(Parameter::of_numbers(&of, "axis", &axis(before), &axis(after)));
        self.parameters.extend(Parameter::of_numbers(&of, "multiplier, offset", &mimic(before), &mimic(after)));
        let limits = numbers_of(&before.limits).into_iter().zip(numbers_of(&after.limits));
        self.without_effect
            .extend(limits.filter_map(|((name, old), (_, new))| Parameter::of_numbers(&of, name, &old, &new)));
    }
}

/// Limits, each as no number or one.
fn numbers_of(limits: &Limits) -> [(&'static str, Vec<f64>); 7] {
    let given = |limit: Option<f64>| limit.into_iter().collect();
    [
        ("lower limit", given(limits.lower)),
        ("upper limit", given(limits.upper)),
        ("effort limit", given(limits.effort)),
        ("velocity limit", given(limits.velocity)),
        ("damping", vec![limits.damping]),
        ("friction", vec![limits.friction]),
        ("rotor inertia", vec![limits.rotor_inertia]),
    ]
}

impl Parameter {
    /// A change of numbers, if there is one.
    fn of_numbers(of: &str, name: &'static str, old: &[f64], new: &[f64]) -> Option<Self> {
        if old == new {
            return None;
        }
        let relative = match (old, new) {
            ([old], [new]) => Some((new - old) / old.abs()),
            (old, new) if old.len() == new.len() => {
                let moved: Vec<f64> = old.iter().zip(new).map(|(old, new)| new - old).collect();
                Some(norm(&moved) / norm(old))
            }
            _ => None,
        };
        let relative = relative.filter(|relative| relative.is_finite());
        Some(Self { of: of.into(), name, old: value(old), new: value(new), relative })
    }
}

fn norm(numbers: &[f64]) -> f64 {
    numbers.iter().map(|number| number * number).sum::<f64>().sqrt()
}

/// No number, a number, or several.
fn value(numbers: &[f64]) -> Value {
    match numbers {
        [] => Value::Null,
        [number] => json!(number),
        numbers => json!(numbers),
    }
}
