//! Other masses make the robot that is described with them.

use std::fs;
use std::path::Path;

use frs_core::Model;
use frs_core::lanes::F64x4;
use frs_core::model::Inertial;
use frs_core::spatial::Symmetric3;
use nalgebra::Vector3;
use proptest::prelude::*;
use proptest::sample::Index;

use crate::answers::{Answers, states};
use crate::robots::{bits, config, inertial, robots};

/// Two ways to one number, on robots of up to nine bodies at unit scale.
const ROUNDING: f64 = 1e-11;

/// Each link with mass is given the mass distribution that it has.
fn assert_own_parameters_change_nothing(model: &Model) {
    for link in model.links().iter().filter(|link| link.inertial.mass > 0.0) {
        let same = model.with_inertial(&link.name, link.inertial).unwrap();
        assert_eq!(bits(&same), bits(model), "link '{}' of '{}'", link.name, model.name());
    }
}

#[test]
fn robots_with_their_own_parameters_are_the_same_bit_for_bit() {
    let robots = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots");
    let files = [robots.clone(), robots.join("oracles")].map(|folder| fs::read_dir(folder).unwrap());
    for path in files.into_iter().flatten().map(|file| file.unwrap().path()).filter(|path| path.is_file()) {
        let urdf = fs::read_to_string(path).unwrap();
        assert_own_parameters_change_nothing(&Model::from_urdf(&urdf).unwrap());
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn trees_with_their_own_parameters_are_the_same_bit_for_bit(robot in robots()) {
        assert_own_parameters_change_nothing(&robot.build().unwrap());
    }

    /// Bodies other than the base are the same bit for bit; the described base has its frame at its new centre of mass.
    #[test]
    fn other_parameters_make_the_robot_described_with_them(
        mut robot in robots(), link in any::<Index>(), other in inertial(), state in states(),
    ) {
        let link = link.index(robot.links.len());
        let found = robot.build().unwrap().with_inertial(&robot.links[link].name, other).unwrap();
        robot.links[link].inertial = other;
        let expected = robot.build().unwrap();
        for (found, expected) in found.bodies().iter().zip(expected.bodies()).skip(1) {
            prop_assert_eq!((found.mass, found.com, found.inertia), (expected.mass, expected.com, expected.inertia));
        }
        let (found, expected) = (Answers::new(&found, &state), Answers::new(&expected, &state));
        for (found, expected) in found.matrices().into_iter().zip(expected.matrices()) {
            let scale = expected.amax().max(1.0);
            prop_assert!((found - expected).amax() < ROUNDING * scale, "{} is not {}", found, expected);
        }
    }

    /// No number decides what is computed: four mass distributions at once are four robots, bit for bit.
    #[test]
    fn parameters_have_no_say_in_what_is_computed(
        robot in robots(), link in any::<Index>(), others in prop::array::uniform4(inertial()),
    ) {
        let model = robot.build().unwrap();
        let link = &robot.links[link.index(robot.links.len())].name;
        let lanes = |of: fn(&Inertial) -> f64| F64x4::from_array(others.each_ref().map(of));
        let four = Inertial {
            mass: lanes(|i| i.mass),
            com: Vector3::new(lanes(|i| i.com.x), lanes(|i| i.com.y), lanes(|i| i.com.z)),
            inertia: Symmetric3 {
                xx: lanes(|i| i.inertia.xx),
                xy: lanes(|i| i.inertia.xy),
                xz: lanes(|i| i.inertia.xz),
                yy: lanes(|i| i.inertia.yy),
                yz: lanes(|i| i.inertia.yz),
                zz: lanes(|i| i.inertia.zz),
            },
        };
        let four = model.cast::<F64x4>().with_inertial(link, four).unwrap();
        for (lane, other) in others.into_iter().enumerate() {
            let one = model.with_inertial(link, other).unwrap();
            prop_assert_eq!(bits(&four.map(|number| number.to_array()[lane])), bits(&one));
        }
    }
}
