//! Each case's robot as generated code.

use frs_macros::frs_model;

frs_model!([::frs_core] pub mod p1 = "../robots/oracles/p1.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod p2 = "../robots/oracles/p2.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod p3 = "../robots/oracles/p3.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod p4 = "../robots/oracles/p4.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod p5 = "../robots/oracles/p5.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod p6 = "../robots/oracles/p6.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod p7 = "../robots/oracles/p7.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod p8 = "../robots/oracles/p8.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod p9 = "../robots/oracles/p9.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod s0 = "../robots/oracles/s0.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod g1 = "../robots/oracles/g1.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod g2 = "../robots/oracles/g2.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod d1 = "../robots/oracles/d1.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod d2 = "../robots/oracles/d2.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod d3 = "../robots/oracles/d3.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod d4 = "../robots/oracles/d4.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod d5 = "../robots/oracles/d5.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod c1 = "../robots/oracles/c1.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod c2 = "../robots/oracles/c2.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod m1 = "../robots/oracles/m1.urdf", outputs(inertia, curvature));
frs_model!([::frs_core] pub mod m2 = "../robots/oracles/m2.urdf", outputs(inertia, curvature));
