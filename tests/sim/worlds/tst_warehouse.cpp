// What was ordered of `warehouse`, for twenty seeds: a closed hall whose ramps can be driven and whose goods stand.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/physics/physics.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/worlds/made_worlds.h"
#include "tests/sim/talker.h"
#include "tests/sim/worlds/made_world.h"
#include "tests/suite/suite.h"

namespace tst_warehouse {

using namespace usar;
using namespace usar::sim;

namespace {

/// How deep two upright boxes are in one another.
double depth_m(const Box& a, const Box& b) {
    const Vec3 apart_m = (a.center_in_map.position_m - b.center_in_map.position_m).cwiseAbs();
    return ((a.size_m + b.size_m) / 2.0 - apart_m).minCoeff();
}

std::vector<Box> rampsOf(const World& warehouse) {
    std::vector<Box> ramps;
    std::ranges::copy_if(warehouse.boxes, std::back_inserter(ramps),
                         [](const Box& box) { return !isTurnedLevel(box) && box.size_m.y() > 1.0; });
    return ramps;
}

} // namespace

class tst_Warehouse : public QObject {
    Q_OBJECT

private slots:
    void theHallIsClosed_data() { addSeeds(); }
    void theHallIsClosed() {
        QFETCH(const int, seed);
        const World& hall = madeWorld("warehouse", seed);
        const RayCaster caster(hall);
        QVERIFY(caster.roofed());
        const double longest_m = Vec3(40.0, 30.0, 9.0).norm() + 1e-6;
        Random random = seeded(52, 1);
        for (int i = 0; i < 20000; ++i) {
            const Vec3 from_m{uniform(random, -20.0, 20.0), uniform(random, -15.0, 15.0), uniform(random, 0.0, 9.0)};
            QVERIFY(caster.cast(from_m, randomDirection(random), 1000.0) <= longest_m);
        }
        for (const NamedPose& start : hall.start_poses) {
            const Vec3& at_m = start.pose_in_map.position_m;
            QVERIFY(std::abs(at_m.z() + caster.cast(at_m, Vec3::UnitZ(), 1000.0) - 9.0) < 1e-9);
        }
    }

    void twoDoorwaysLeadToTheDock_data() { addSeeds(); }
    void twoDoorwaysLeadToTheDock() {
        QFETCH(const int, seed);
        const RayCaster caster(madeWorld("warehouse", seed));
        const auto isOpen = [&](double y_m, double z_m) {
            return caster.cast({9.5, y_m, z_m}, Vec3::UnitX(), 1.0) == 1.0;
        };
        int doors = 0;
        double open_m = 0.0;
        for (double y_m = -14.995; y_m < 15.0; y_m += 0.01) {
            doors += isOpen(y_m, 1.8) && !isOpen(y_m - 0.01, 1.8) ? 1 : 0;
            open_m += isOpen(y_m, 1.8) ? 0.01 : 0.0;
            QCOMPARE(isOpen(y_m, 0.05), isOpen(y_m, 1.8));
            QCOMPARE(isOpen(y_m, 3.95), isOpen(y_m, 1.8));
            QVERIFY(!isOpen(y_m, 4.05) && !isOpen(y_m, 8.95));
        }
        QCOMPARE(doors, 2);
        QVERIFY2(std::abs(open_m - 6.0) < 0.05, std::to_string(open_m).c_str());
    }

    void rampsLeadUpWithoutAStep_data() { addSeeds(); }
    void rampsLeadUpWithoutAStep() {
        QFETCH(const int, seed);
        const World& hall = madeWorld("warehouse", seed);
        const RayCaster caster(hall);
        const std::vector<Box> ramps = rampsOf(hall);
        QCOMPARE(ramps.size(), std::size_t{2});
        double highest_m = 0.0;
        for (const Box& ramp : ramps) {
            QVERIFY(std::abs(ramp.center_in_map.pitch_rad) < steepest_rad);
            const Vec2 foot_m = pointOf(ramp, -1.0, 0.0, 1.0).head<2>();
            const Vec2 top_m = pointOf(ramp, 1.0, 0.0, 1.0).head<2>();
            const Vec2 ahead = (top_m - foot_m).normalized();
            for (const double beside_m : {-0.9, 0.0, 0.9}) {
                const Vec2 side_m = beside_m * Vec2(-ahead.y(), ahead.x());
                double before_m = caster.surface_m(foot_m + side_m - ahead);
                QCOMPARE(before_m, 0.0);
                for (double way_m = -1.0; way_m < (top_m - foot_m).norm() + 1.5; way_m += 0.01) {
                    const Vec2 at_m = foot_m + side_m + way_m * ahead;
                    const double here_m = caster.surface_m(at_m);
                    QVERIFY2(here_m - before_m > -1e-6 && here_m - before_m < 0.01 * std::tan(steepest_rad) + 0.001,
                             qPrintable(QString("%1 m to %2 m").arg(before_m).arg(here_m)));
                    QVERIFY(caster.cast({at_m.x(), at_m.y(), here_m + 0.01}, Vec3::UnitZ(), 2.0) == 2.0);
                    before_m = here_m;
                }
                highest_m = std::max(highest_m, before_m);
                const double end_m = pointOf(ramp, 1.0, 0.0, 1.0).z();
                QVERIFY(std::abs(before_m - end_m) < 0.002);
            }
        }
        QCOMPARE(highest_m, mezzanine_m);
    }

    void aP2dxClimbsToTheMezzanine() {
        const World& hall = madeWorld("warehouse", 1);
        const auto simulation = simulationOf(hall);
        Talker talker(*simulation);
        const Vec3& at_m = startOf(hall, "RampFoot");
        talker.say("INIT {ClassName USARBot.P2DX} {Name R1} {Location " + std::to_string(at_m.x()) + "," +
                   std::to_string(-at_m.y()) + "," + std::to_string(-at_m.z()) + "} {Rotation 0,0,3.14159}");
        steps(*simulation, 10);
        talker.say("DRIVE {Left 5} {Right 5}"); // rad/s, that is 0.49 m/s
        steps(*simulation, 240);
        const Vec3 end_m = simulation->robots().at(0).base_in_map.position_m;
        QVERIFY2(end_m.x() < -13.5 && end_m.z() > mezzanine_m && end_m.z() < mezzanine_m + 0.5,
                 qPrintable(QString("%1 %2 %3").arg(end_m.x()).arg(end_m.y()).arg(end_m.z())));
    }

    void goodsStandOnSomethingAndInNothing_data() { addSeeds(); }
    void goodsStandOnSomethingAndInNothing() {
        QFETCH(const int, seed);
        const World& hall = madeWorld("warehouse", seed);
        int loads = 0;
        for (std::size_t i = 5; i < hall.boxes.size(); ++i) { // after four walls and the roof
            const Box& box = hall.boxes[i];
            const bool rail = box.size_m.minCoeff() < 0.07;
            const bool load = box.size_m.maxCoeff() < 1.5 && !rail;
            QVERIFY2(isSupported(hall, box) || (!load && isHeld(hall, box)), std::to_string(i).c_str());
            loads += load ? 1 : 0;
            for (std::size_t j = 5; j < i && isUpright(box); ++j)
                if (const Box& other = hall.boxes[j]; isUpright(other) && !(rail && other.size_m.minCoeff() < 0.07))
                    QVERIFY2(depth_m(box, other) < 1e-6, qPrintable(QString("%1 in %2").arg(i).arg(j)));
        }
        QVERIFY2(loads > 100, std::to_string(loads).c_str());
    }

    void looseThingsRestWhereTheyAre_data() { addSeeds(); }
    void looseThingsRestWhereTheyAre() {
        QFETCH(const int, seed);
        const World& hall = madeWorld("warehouse", seed);
        QVERIFY(hall.objects.size() >= 8);
        const auto physics = makePhysics(hall);
        std::set<std::string> names;
        std::vector<BodyId> bodies;
        for (const WorldObject& object : hall.objects) {
            names.insert(object.name);
            bodies.push_back(physics->add(object.body, object.body_in_map));
        }
        QCOMPARE(names.size(), hall.objects.size());
        for (const BodyId body : bodies)
            QVERIFY(!physics->isStuck(body));
        for (int step = 0; step < 500; ++step)
            physics->step(Seconds(0.004));
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const Vec3 moved_m = physics->state(bodies[i]).position_m - hall.objects[i].body_in_map.position_m;
            QVERIFY2(moved_m.norm() < 0.01, hall.objects[i].name.c_str());
        }
    }
};

USAR_TEST(tst_Warehouse)

} // namespace tst_warehouse

#include "tst_warehouse.moc"
