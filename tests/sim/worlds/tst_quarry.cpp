// What was ordered of `quarry`, for twenty seeds: benches, ledges with room under them, one pond.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/rays/ray_caster.h"
#include "tests/sim/worlds/made_world.h"
#include "tests/suite/suite.h"

namespace tst_quarry {

using namespace usar;
using namespace usar::sim;

namespace {

/// Ledges are the wide boxes that lie level; boulders are tilted.
std::vector<Box> ledgesOf(const World& quarry) {
    std::vector<Box> ledges;
    std::ranges::copy_if(quarry.boxes, std::back_inserter(ledges), isTurnedLevel);
    return ledges;
}

} // namespace

class tst_Quarry : public QObject {
    Q_OBJECT

private slots:
    void benchesAreAboveOneAnother_data() { addSeeds(); }
    void benchesAreAboveOneAnother() {
        QFETCH(const int, seed);
        const World& quarry = madeWorld("quarry", seed);
        const std::array starts{"PitFloor", "LowerBench", "PlayerStart", "UpperBench", "Rim"};
        for (std::size_t i = 1; i < starts.size(); ++i) {
            const double rise_m = startOf(quarry, starts[i]).z() - startOf(quarry, starts[i - 1]).z();
            QVERIFY2(rise_m > 4.3 && rise_m < 7.7, starts[i]);
        }
        int steep = 0;
        for (double x = -74.0; x < 74.0; x += 0.5)
            for (double y = -74.0; y < 74.0; y += 0.5) {
                const Vec2 rise{quarry.terrain.height_m({x + 0.1, y}) - quarry.terrain.height_m({x - 0.1, y}),
                                quarry.terrain.height_m({x, y + 0.1}) - quarry.terrain.height_m({x, y - 0.1})};
                steep += rise.norm() / 0.2 > std::tan(radians(60.0)) ? 1 : 0;
            }
        const double share = steep / (296.0 * 296.0);
        QVERIFY2(share > 0.02 && share < 0.15, std::to_string(share).c_str());
    }

    void thePondIsAllTheWater_data() { addSeeds(); }
    void thePondIsAllTheWater() {
        QFETCH(const int, seed);
        const World& quarry = madeWorld("quarry", seed);
        const double water_z_m = quarry.water.value().surface_z_m;
        QVERIFY(static_cast<double>(quarry.terrain.minimum_m()) < water_z_m - 2.5);
        double area_m2 = 0.0;
        for (double x = -74.75; x < 75.0; x += 0.5)
            for (double y = -74.75; y < 75.0; y += 0.5)
                if (quarry.terrain.height_m({x, y}) < water_z_m) {
                    area_m2 += 0.25;
                    QVERIFY(Vec2(x, y).norm() < 18.0);
                }
        QVERIFY2(area_m2 > 150.0 && area_m2 < 800.0, std::to_string(area_m2).c_str());
    }

    void ledgesJutOutOverLowerBenches_data() { addSeeds(); }
    void ledgesJutOutOverLowerBenches() {
        QFETCH(const int, seed);
        const World& quarry = madeWorld("quarry", seed);
        const RayCaster caster(quarry);
        const std::vector<Box> ledges = ledgesOf(quarry);
        QVERIFY2(ledges.size() >= 6, std::to_string(ledges.size()).c_str());
        for (const Box& ledge : ledges) {
            for (const double y : {-0.8, 0.0, 0.8}) {
                const Vec3 inner_m = pointOf(ledge, -0.95, y, -1.0);
                QVERIFY(inner_m.z() < quarry.terrain.height_m(inner_m.head<2>())); // it is held by the rock
            }
            const Vec3 under_m = pointOf(ledge, 0.8, 0.0, -1.0) - Vec3(0.0, 0.0, 0.01);
            const double free_m = caster.cast(under_m, -Vec3::UnitZ(), 20.0);
            QVERIFY2(free_m > 2.0 && free_m < 8.0, std::to_string(free_m).c_str());
            QVERIFY(std::abs(caster.surface_m(under_m.head<2>()) - pointOf(ledge, 0.0, 0.0, 1.0).z()) < 1e-6);
        }
    }

    void bouldersLieInTheGround_data() { addSeeds(); }
    void bouldersLieInTheGround() {
        QFETCH(const int, seed);
        const World& quarry = madeWorld("quarry", seed);
        int boulders = 0;
        for (const Box& box : quarry.boxes)
            if (!isTurnedLevel(box)) {
                ++boulders;
                const Vec3& at_m = box.center_in_map.position_m;
                QVERIFY(at_m.z() - box.size_m.minCoeff() / 2.0 < quarry.terrain.height_m(at_m.head<2>()));
            }
        QVERIFY2(boulders >= 60, std::to_string(boulders).c_str());
    }
};

USAR_TEST(tst_Quarry)

} // namespace tst_quarry

#include "tst_quarry.moc"
