//! Each robot's URDF and the same robot built in code.

use frs_oracles::Case;

/// Every number, name and limit of the model; shortest decimal digits tell any two doubles apart.
fn built_in_code_is_the_urdf(case: Case) {
    let built = case.robot().build().unwrap_or_else(|error| panic!("{case:?}: {error}"));
    assert_eq!(format!("{:?}", case.model()), format!("{built:?}"), "{case:?}");
    assert!(built.warnings().is_empty(), "{case:?}: {:?}", built.warnings());
    assert_eq!(built.name(), case.id().to_lowercase());
}

every_case!(built_in_code_is_the_urdf);

#[test]
fn every_case_is_tested_and_has_pairs_unless_it_has_one_coordinate() {
    assert_eq!(Case::ALL.len(), 21);
    let alone: Vec<_> = Case::ALL.iter().filter(|case| case.model().dof() == 1).collect();
    assert_eq!(alone, [&Case::P1, &Case::P2, &Case::P4]);
}

#[test]
fn cases_are_found_by_their_names() {
    for &case in Case::ALL {
        assert_eq!(Case::named(case.id()), Some(case));
        assert_eq!(Case::named(&case.id().to_lowercase()), Some(case));
    }
    assert_eq!(Case::named("p10"), None);
}
