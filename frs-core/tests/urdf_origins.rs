//! The angles of a URDF's origins become the same rotation on every machine.

use frs_core::urdf::{Options, parse};

/// rad; at each of them the sine or cosine of some mathematics libraries is the other neighbour of the exact number.
const ANGLES: [f64; 3] = [0.117, 0.24, 0.424];

/// sin, cos of [`ANGLES`], as the algorithm of FreeBSD's msun rounds them.
const SIN_COS: [(f64, f64); 3] = [
    (0.11673324714446585, 0.9931633043015177),
    (0.23770262642713458, 0.9713379748520296),
    (0.41140953700193683, 0.9114505981477284),
];

#[test]
fn origins_do_not_depend_on_the_machine() {
    let [roll, pitch, yaw] = ANGLES;
    let urdf = format!(
        "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='fixed'>\
         <parent link='a'/><child link='b'/><origin rpy='{roll} {pitch} {yaw}'/></joint></robot>"
    );
    let robot = parse(&urdf, &Options::default()).unwrap();
    let [(sr, cr), (sp, cp), (sy, cy)] = SIN_COS;
    // The entries that are a product of at most two.
    let r = robot.joints[0].origin.rotation;
    let found = [r.m11, r.m21, r.m31, r.m32, r.m33];
    assert_eq!(found.map(f64::to_bits), [cy * cp, sy * cp, -sp, cp * sr, cp * cr].map(f64::to_bits));
}
