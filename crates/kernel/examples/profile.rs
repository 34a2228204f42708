use std::time::Instant;
#[path = "../tests/common/mod.rs"]
mod common;
use common::*;
fn main() {
    let flex = Tooth { offset: -0.0072, ..flexspline() };
    let fp = flex.profile().unwrap();
    let cp = circular_spline().profile().unwrap();
    let n = 300;
    let shape = std::sync::Arc::new(strainwave_kernel::RingShape::Harmonics(vec![0.0, 1.0]).sampled().unwrap());
    let cosine = |w0, model| strainwave_kernel::NeutralCurve::polar(NEUTRAL_RADIUS, w0, model, &shape).unwrap();
    let t = Instant::now();
    for i in 0..n {
        std::hint::black_box(cosine(0.8 + 1e-4 * i as f64, strainwave_kernel::NeutralCurveModel::FirstOrder));
    }
    println!("curve first-order {:.2} us", t.elapsed().as_secs_f64() * 1e6 / n as f64);
    let t = Instant::now();
    for i in 0..n {
        std::hint::black_box(cosine(0.8 + 1e-4 * i as f64, strainwave_kernel::NeutralCurveModel::Inextensible));
    }
    println!("curve inextensible {:.2} us", t.elapsed().as_secs_f64() * 1e6 / n as f64);
    let t = Instant::now();
    for _ in 0..n {
        std::hint::black_box(flex.profile().unwrap());
    }
    println!("profile {:.2} us", t.elapsed().as_secs_f64() * 1e6 / n as f64);
    let curve = cosine(0.848, strainwave_kernel::NeutralCurveModel::FirstOrder);
    let t = Instant::now();
    for _ in 0..n {
        std::hint::black_box(strainwave_kernel::Engagement::new(fp.clone(), cp.clone(), curve.clone()).unwrap());
    }
    println!("engagement {:.2} us", t.elapsed().as_secs_f64() * 1e6 / n as f64);
    let e = strainwave_kernel::Engagement::new(fp.clone(), cp.clone(), curve.clone()).unwrap();
    let t = Instant::now();
    for _ in 0..n {
        for k in 0..52 {
            std::hint::black_box(e.relative_pose(k as f64));
        }
    }
    println!("52 poses {:.2} us", t.elapsed().as_secs_f64() * 1e6 / n as f64);
    let t = Instant::now();
    for _ in 0..n {
        for k in 0..52 {
            std::hint::black_box(e.clearances(&e.relative_pose(k as f64)));
        }
    }
    println!("52 clearances {:.2} us", t.elapsed().as_secs_f64() * 1e6 / n as f64);
    let t = Instant::now();
    for _ in 0..n {
        std::hint::black_box(e.distribution());
    }
    println!("distribution {:.2} us", t.elapsed().as_secs_f64() * 1e6 / n as f64);
    for (k, d) in e.distribution().iter().enumerate() {
        let c = e.clearances(&e.relative_pose(k as f64));
        if c.left.gap != d.left || c.right.gap != d.right {
            println!("differs {k} {} {}", c.left.gap - d.left, c.right.gap - d.right);
        }
    }
    let ei = engagement(&flexspline(), &circular_spline(), 0.848);
    let t = Instant::now();
    for _ in 0..n {
        std::hint::black_box(ei.distribution());
    }
    println!("distribution interfering {:.2} us", t.elapsed().as_secs_f64() * 1e6 / n as f64);
    let t = Instant::now();
    for _ in 0..20 {
        std::hint::black_box(e.minimum_in_motion(1e-6));
    }
    println!("motion {:.2} us", t.elapsed().as_secs_f64() * 1e6 / 20.0);
}
