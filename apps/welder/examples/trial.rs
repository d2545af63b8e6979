fn main() {
    let mut args = std::env::args().skip(1);
    let case = args.next().unwrap();
    let sets: Vec<String> = args.collect();
    let case = welder::case::load(std::path::Path::new(&case), &sets)
        .unwrap_or_else(|e| panic!("{}", e.report(false)));
    let t0 = std::time::Instant::now();
    let model = welder::model::Model::from_case(&case).unwrap();
    let plan = welder::run::level_plan(&model, 0.0).unwrap();
    let t1 = std::time::Instant::now();
    let mut sim = welder::run::Simulation::with_plan(model, &plan).unwrap();
    let t2 = std::time::Instant::now();
    sim.run_quietly().unwrap();
    let t3 = std::time::Instant::now();
    let r = sim.records();
    println!(
        "n {} levels {} finest {:?} steps {} {:?} pilot {:.3} setup {:.3} loop {:.3}",
        sim.particles().len(),
        sim.workpiece().levels,
        sim.workpiece().finest.counts(),
        sim.steps(),
        sim.cost(),
        (t1 - t0).as_secs_f64(),
        (t2 - t1).as_secs_f64(),
        (t3 - t2).as_secs_f64()
    );
    println!("{:?}", sim.limits());
    println!(
        "peak {:.1} W {:.6} D {:.6} Ws {:.6} Ds {:.6} solid {:?} weld {:?} L {:.6}",
        r.peak_temperature,
        r.liquidus.width * 1e3,
        r.liquidus.depth * 1e3,
        r.solidus.width * 1e3,
        r.solidus.depth * 1e3,
        r.solidified_at,
        sim.gauge().weld(),
        r.liquidus.length * 1e3
    );
    println!("{:?}", sim.ledger());
}
