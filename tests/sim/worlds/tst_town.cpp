// What was ordered of `town`, for twenty seeds: wires that hang free, solid houses; and what a sonar hears of a wire.
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
#include "core/sim/sensors/rays.h"
#include "core/sim/worlds/made_worlds.h"
#include "tests/sim/worlds/made_world.h"
#include "tests/suite/suite.h"

namespace tst_town {

using namespace usar;
using namespace usar::sim;

namespace {

bool isWire(const Box& box) {
    return box.size_m.y() == wire_m && box.size_m.z() == wire_m;
}
bool isMast(const Plant& plant) {
    return plant.crown_radius_m == 0.0;
}

} // namespace

class tst_Town : public QObject {
    Q_OBJECT

private slots:
    void wiresHangBetweenMastTops_data() { addSeeds(); }
    void wiresHangBetweenMastTops() {
        QFETCH(const int, seed);
        const World& town = madeWorld("town", seed);
        const RayCaster caster(town);
        std::vector<Box> pieces;
        std::ranges::copy_if(town.boxes, std::back_inserter(pieces), isWire);
        QVERIFY(pieces.size() % 4 == 0 && pieces.size() >= std::size_t{4 * 10});
        const auto isMastTop = [&](const Vec3& point_m) {
            return std::ranges::any_of(town.plants, [&](const Plant& plant) {
                const Vec3 top_m = plant.base_in_map_m + Vec3(0.0, 0.0, plant.trunk_height_m - 0.1);
                return isMast(plant) && (top_m - point_m).norm() < 0.002;
            });
        };
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Vec3 from_m = pointOf(pieces[i], -1.0, 0.0, 0.0);
            const Vec3 to_m = pointOf(pieces[i], 1.0, 0.0, 0.0);
            QVERIFY(i % 4 == 0 ? isMastTop(from_m) : (pointOf(pieces[i - 1], 1.0, 0.0, 0.0) - from_m).norm() < 0.002);
            QVERIFY(i % 4 != 3 || isMastTop(to_m));
            for (const double share : {0.1, 0.5, 0.9}) {
                const Vec3 at_m = from_m + share * (to_m - from_m);
                const double above_m = at_m.z() - town.terrain.height_m(at_m.head<2>());
                QVERIFY2(above_m > 6.0 && above_m < 9.0, std::to_string(above_m).c_str());
                const Vec3 over_m = at_m + Vec3(0.0, 0.0, 0.2);
                QVERIFY(std::abs(caster.cast(over_m, -Vec3::UnitZ(), 1.0) - 0.2 + wire_m / 2.0) < 0.001);
                const Vec3 beside_m = at_m - 0.2 * (pieces[i].center_in_map.rotation() * Vec3::UnitY());
                QVERIFY(std::abs(caster.cast(beside_m, pieces[i].center_in_map.rotation() * Vec3::UnitY(), 1.0) - 0.2 +
                                 wire_m / 2.0) < 1e-6);
            }
        }
    }

    void onlyMastsTouchTheWires_data() { addSeeds(); }
    void onlyMastsTouchTheWires() {
        QFETCH(const int, seed);
        World town = madeWorld("town", seed);
        std::vector<Box> pieces;
        std::ranges::copy_if(town.boxes, std::back_inserter(pieces), isWire);
        std::erase_if(town.boxes, isWire);
        const RayCaster caster(town);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            // At its ends a wire is fixed to its masts.
            const Vec3 from_m = pointOf(pieces[i], i % 4 == 0 ? -0.7 : -1.0, 0.0, 0.0);
            const Vec3 way_m = pointOf(pieces[i], i % 4 == 3 ? 0.7 : 1.0, 0.0, 0.0) - from_m;
            for (const Vec3& off_m : {Vec3(0.0, 0.0, 0.3), Vec3(0.0, 0.0, -0.3), Vec3(0.0, 0.0, 0.0)})
                QVERIFY(caster.cast(from_m + off_m, way_m.normalized(), way_m.norm()) == way_m.norm());
        }
    }

    void aSonarMeetsAWireOnlyByChance_data() {
        QTest::addColumn<double>("distance_m");
        QTest::addColumn<double>("met_share"); // as robots-and-worlds.md, section 5, says
        QTest::newRow("1 m") << 1.0 << 1.0;
        QTest::newRow("2 m") << 2.0 << 0.68;
        QTest::newRow("3 m") << 3.0 << 0.53;
        QTest::newRow("4 m") << 4.0 << 0.41;
        QTest::newRow("4.9 m") << 4.9 << 0.35;
    }
    void aSonarMeetsAWireOnlyByChance() {
        QFETCH(const double, distance_m);
        QFETCH(const double, met_share);
        World world;
        world.boxes = {{{.position_m = {distance_m, 0.0, 0.0}}, {wire_m, 20.0, wire_m}}};
        const RayCaster caster(world);
        const auto physics = makePhysics(world);
        const BodyId eye = physics->add(BodyDescription{}, Pose{.position_m = {-5.0, 0.0, 0.0}});
        const WorldRays rays(caster, *physics, eye);
        const double half_rad = radians(7.5);
        std::vector<Vec3> directions{Vec3::UnitX()}; // as SonarSensor does
        for (const double off_axis_rad : {half_rad / 2.0, half_rad})
            for (int ray = 0; ray < 16; ++ray)
                directions.push_back(Eigen::AngleAxisd(pi * ray / 8.0, Vec3::UnitX()) *
                                     Vec3(std::cos(off_axis_rad), std::sin(off_axis_rad), 0.0));
        const double reach_m = distance_m * std::tan(half_rad);
        constexpr int places = 4000;
        int met = 0;
        for (int i = 0; i < places; ++i) {
            const double z_m = reach_m * (2.0 * (i + 0.5) / places - 1.0);
            met += rays.nearestEcho({0.0, 0.0, z_m}, directions, 5.0) < 5.0 ? 1 : 0;
        }
        QVERIFY2(std::abs(met / double{places} - met_share) < 0.005, std::to_string(met / double{places}).c_str());
    }

    void housesAreSolidUpToTheRidge_data() { addSeeds(); }
    void housesAreSolidUpToTheRidge() {
        QFETCH(const int, seed);
        const World& town = madeWorld("town", seed);
        std::set<int> heights_dm;
        int houses = 0;
        for (const Box& box : town.boxes) {
            QVERIFY(isWire(box) || isSupported(town, box));
            if (!isUpright(box) || box.size_m.minCoeff() < 4.0)
                continue;
            ++houses;
            const Vec3 top_m = box.center_in_map.position_m + Vec3(0.0, 0.0, box.size_m.z() / 2.0);
            heights_dm.insert(static_cast<int>(10.0 * box.size_m.z()));
            for (const Vec3& corner_m : pointsOfFace(box, -1.0))
                QVERIFY(corner_m.z() < town.terrain.height_m(corner_m.head<2>()));
            std::vector<Box> roof;
            std::ranges::copy_if(town.boxes, std::back_inserter(roof), [&](const Box& other) {
                const Vec2 off_m = other.center_in_map.position_m.head<2>() - top_m.head<2>();
                return !isTurnedLevel(other) && !isWire(other) && off_m.norm() < 3.0;
            });
            QVERIFY(roof.empty() || roof.size() == 2);
            for (const Box& side : roof)
                checkRoof(town, side, top_m.z());
        }
        QVERIFY2(houses >= 40 && houses <= 80, std::to_string(houses).c_str());
        QVERIFY2(heights_dm.size() > 15, std::to_string(heights_dm.size()).c_str());
    }

private:
    /// A half of a roof rises from the eaves to the ridge and leaves no room under it.
    static void checkRoof(const World& town, const Box& side, double eaves_m) {
        const RayCaster caster(town);
        QVERIFY(std::abs(pointOf(side, -1.0, 0.0, 1.0).z() - eaves_m) < 0.002);
        const double ridge_m = pointOf(side, 1.0, 0.0, 1.0).z();
        QVERIFY(ridge_m > eaves_m + 1.0);
        for (const double along : {-0.8, -0.2, 0.3, 0.9}) {
            const Vec3 on_m = pointOf(side, along, 0.5, 1.0);
            if (const double seen_m = caster.surface_m(on_m.head<2>()); seen_m < on_m.z() + 0.001) // no tree above it
                QVERIFY(std::abs(seen_m - on_m.z()) < 0.001);
            for (double z_m = eaves_m + 0.01; z_m < on_m.z(); z_m += 0.1)
                QCOMPARE(caster.cast({on_m.x(), on_m.y(), z_m}, Vec3::UnitX(), 1.0), 0.0);
        }
    }
};

USAR_TEST(tst_Town)

} // namespace tst_town

#include "tst_town.moc"
