use super::{Answer, Cell, Effort, Fault, Job, Load, Mesher, Plan, Quality};
use crate::measure::Cost;
use crate::workshop::Actor;
use std::cell::RefCell;
use std::time::Duration;

const ONE: Mesher = Mesher::Delone { threads: 1 };
const TWO: Mesher = Mesher::Delone { threads: 2 };

fn done(job: &Job, area: f64, hash: &str) -> Result<Answer, Fault> {
    let quality = Quality {
        triangles: 9,
        min_angle: 31.0,
        max_area: 0.5,
        area,
        skinny: 0,
        oversized: 0,
        unexcused: None,
        hash: job.mesher.is_ours().then(|| hash.to_owned()),
    };
    Ok(Answer {
        cost: Cost {
            seconds: 1.0,
            user: 1.0,
            system: 0.0,
            memory: None,
        },
        quality: job.check.then_some(quality),
    })
}

fn carry_out(
    meshers: &[Mesher],
    answer: impl Fn(&Job) -> Result<Answer, Fault>,
) -> (Vec<Cell>, Vec<Job>) {
    let plan = Plan {
        meshers: meshers.to_vec(),
        outlines: vec!["square".parse().unwrap()],
        loads: vec![Load::AngleOnly, Load::About(1000)],
        angles: vec![20.0, 30.0],
        effort: Effort {
            runs: 2,
            warmups: 1,
            seed: 1,
            timeout: Duration::from_secs(1),
        },
    };
    let actor = Actor {
        answer,
        asked: RefCell::default(),
    };
    let cells = plan.run(&actor, &mut |_| {});
    (cells, actor.asked.into_inner())
}

fn how(cell: &Cell) -> &str {
    match &cell.mesh {
        Err(Fault::Failed { how, .. }) => how,
        other => panic!("{other:?} is no failure"),
    }
}

#[test]
fn warmups_are_discarded_and_meshers_take_turns() {
    let (cells, asked) = carry_out(&[ONE, Mesher::Triangle], |job| done(job, 1.0, "h"));
    assert_eq!(cells.len(), 2 * 4);
    assert!(
        cells
            .iter()
            .all(|cell| cell.mesh.is_ok() && cell.runs.len() == 2)
    );
    let first_group = &asked[..2 * 4];
    let meshers: Vec<_> = first_group.iter().map(|job| job.mesher).collect();
    assert_eq!(meshers, [ONE, Mesher::Triangle].repeat(4));
    let checked = first_group.iter().map(|job| job.check).take(3);
    assert!(checked.eq([true, true, false]));
    let areas: Vec<_> = cells.iter().step_by(2).map(|cell| cell.goal.area).collect();
    assert_eq!(areas, [None, None, Some(1.55e-3), Some(1.55e-3)]);
}

#[test]
fn whoever_hangs_is_not_asked_for_more() {
    let limit = Duration::from_secs(1);
    let (cells, asked) = carry_out(&[Mesher::Cgal], |job| {
        if job.goal.angle > 25.0 {
            return Err(Fault::TimedOut(limit));
        }
        done(job, 1.0, "")
    });
    // Checked and timed at 20 degrees with each load, and tried once at 30.
    assert_eq!(asked.len(), 2 * 4 + 1);
    let hung = cells
        .iter()
        .map(|cell| cell.mesh == Err(Fault::TimedOut(limit)));
    assert!(hung.eq([false, true, false, true]));
}

#[test]
fn a_mesh_must_cover_the_domain() {
    let (cells, asked) = carry_out(&[Mesher::Spade], |job| done(job, 1.001, ""));
    assert!(cells.iter().all(|cell| how(cell) == "area"));
    assert_eq!(asked.len(), 4, "nothing is timed");
}

#[test]
fn our_mesh_must_not_depend_on_threads() {
    let (cells, _) = carry_out(&[ONE, TWO], |job| done(job, 1.0, &job.mesher.to_string()));
    assert!(cells[0].mesh.is_ok());
    assert_eq!(how(&cells[1]), "differs");
}

#[test]
fn a_crash_under_the_clock_revokes_the_mesh() {
    let (cells, _) = carry_out(&[Mesher::Spade], |job| {
        if job.check {
            return done(job, 1.0, "");
        }
        Err(Fault::failed("panic", "index"))
    });
    assert_eq!(how(&cells[0]), "panic");
}

#[test]
fn whoever_knows_no_angles_runs_once_for_each_load() {
    let (cells, _) = carry_out(&[Mesher::Gmsh], |job| done(job, 1.0, ""));
    let goals: Vec<_> = cells.iter().map(|c| (c.goal.angle, c.load)).collect();
    assert_eq!(goals, [(20.0, Load::AngleOnly), (20.0, Load::About(1000))]);
}
