//! One thread is one thread: whoever asks for it starts no pool of the machine. A process has but one of those, so this is
//! the only test here.

#![cfg(feature = "rayon")]

use delone::voronoi::Voronoi;
use delone::{ConstrainedDelaunay, Pslg, on_threads};

#[test]
fn one_thread_starts_no_pool_of_the_machine() {
    let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
    let alone = || {
        let t = ConstrainedDelaunay::new().triangulate(Pslg::from_points(square))?;
        // Here the pool of one thread is the surrounding one, and is used again.
        let voronoi = on_threads(1, || Voronoi::new(t.triangulation(), &()))??;
        Ok::<_, delone::Error>((voronoi.edges().len(), rayon::current_num_threads()))
    };
    let (_, threads) = on_threads(1, alone).expect("a thread").expect("cells");
    assert_eq!(threads, 1);
    let global = rayon::ThreadPoolBuilder::new().num_threads(3);
    global.build_global().expect("a pool has been started");
    assert_eq!(
        on_threads(3, rayon::current_num_threads).expect("threads"),
        3
    );
    assert_eq!(
        on_threads(1, rayon::current_num_threads).expect("a thread"),
        1
    );
}
