// What `warehouse`, `town` and `quarry` have in common, for twenty seeds of each.
#include <cmath>
#include <queue>
#include <set>
#include <string>
#include <utility>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/rays/ray_caster.h"
#include "core/sim/world/world_generator.h"
#include "core/sim/worlds/made_worlds.h"
#include "tests/sim/worlds/made_world.h"
#include "tests/suite/suite.h"

namespace tst_made_worlds {

using namespace usar;
using namespace usar::sim;

namespace {

/// Where a ground robot gets to from one place on open ground that is nowhere steeper than `steepest_rad`.
class Reach {
public:
    Reach(const World& world, const Vec2& from_m) : extent_(world.terrain.extent()) {
        const RayCaster caster(world);
        std::queue<Eigen::Vector2i> border;
        border.push(cellOf(from_m));
        while (!border.empty()) {
            const Eigen::Vector2i cell = border.front();
            border.pop();
            for (const Eigen::Vector2i& way : {Eigen::Vector2i(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const Vec2 next_m = pointAt(cell + way);
                if (extent_.contains(next_m) && !contains(next_m) && isGentle(world.terrain, pointAt(cell), next_m) &&
                    caster.surface_m(next_m) - world.terrain.height_m(next_m) < 1e-6) {
                    cells_.emplace(cellOf(next_m).x(), cellOf(next_m).y());
                    border.push(cell + way);
                }
            }
        }
    }

    bool contains(const Vec2& point_m) const { return cells_.contains({cellOf(point_m).x(), cellOf(point_m).y()}); }

private:
    static constexpr double step_m = 0.5;

    /// Looks at tenths of a meter, so that it does not step over a curb.
    static bool isGentle(const Terrain& terrain, const Vec2& from_m, const Vec2& to_m) {
        for (int part = 0; part < 5; ++part) {
            const Vec2 a_m = from_m + 0.2 * part * (to_m - from_m);
            const Vec2 b_m = a_m + 0.2 * (to_m - from_m);
            if (std::abs(terrain.height_m(b_m) - terrain.height_m(a_m)) > (b_m - a_m).norm() * std::tan(steepest_rad))
                return false;
        }
        return true;
    }

    Eigen::Vector2i cellOf(const Vec2& point_m) const {
        return ((point_m - extent_.min_m) / step_m).array().floor().cast<int>();
    }
    Vec2 pointAt(const Eigen::Vector2i& cell) const {
        return extent_.min_m + step_m * (cell.cast<double>() + Vec2::Constant(0.5));
    }

    Rectangle extent_;
    std::set<std::pair<int, int>> cells_;
};

} // namespace

class tst_MadeWorlds : public QObject {
    Q_OBJECT

private slots:
    void startsStandFree_data() { addWorlds(); }
    void startsStandFree() {
        QFETCH(const QString, name);
        QFETCH(const int, seed);
        const World& world = madeWorld(name.toStdString(), seed);
        const RayCaster caster(world);
        Random random = seeded(51, 1);
        QVERIFY(world.start_poses.size() >= 5);
        for (const NamedPose& start : world.start_poses) {
            const Vec3& at_m = start.pose_in_map.position_m;
            QVERIFY2(std::abs(caster.cast(at_m, -Vec3::UnitZ(), 1.0) - 0.35) < 0.002, start.name.c_str());
            QVERIFY(!world.water || at_m.z() > world.water->surface_z_m + 0.5);
            for (int i = 0; i < 300; ++i) {
                Vec3 direction = randomDirection(random);
                direction.z() = std::abs(direction.z());
                QVERIFY2(caster.cast(at_m, direction, 1.0) == 1.0, start.name.c_str());
            }
            const bool upstairs = at_m.z() - world.terrain.height_m(at_m.head<2>()) > 1.0;
            const double roof_m = name == "warehouse" ? 9.0 - (upstairs ? mezzanine_m : 0.0) - 0.01 : 100.0;
            const double open_m = name == "warehouse" ? 1.4 : name == "town" ? 3.5 : 5.0;
            for (int i = 0; i < 3000; ++i) { // so many that a wire does not pass between them
                const Vec2 off_m{uniform(random, -open_m, open_m), uniform(random, -open_m, open_m)};
                if (off_m.norm() > open_m)
                    continue;
                const Vec2 near_m = at_m.head<2>() + off_m;
                const double ground_m = upstairs ? mezzanine_m : world.terrain.height_m(near_m);
                QVERIFY2(std::abs(caster.surface_m(near_m) - ground_m) < 1e-9, start.name.c_str());
                const double up_m = caster.cast({near_m.x(), near_m.y(), ground_m + 0.01}, Vec3::UnitZ(), 100.0);
                QVERIFY2(std::abs(up_m - roof_m) < 1e-6, start.name.c_str());
            }
        }
    }

    void nothingIsBuried_data() { addWorlds(); }
    void nothingIsBuried() {
        QFETCH(const QString, name);
        QFETCH(const int, seed);
        const World& world = madeWorld(name.toStdString(), seed);
        for (const Box& box : world.boxes) {
            QVERIFY(box.size_m.minCoeff() > 0.0);
            QVERIFY(std::ranges::any_of(pointsOfFace(box, 1.0), [&](const Vec3& point_m) {
                return point_m.z() > world.terrain.height_m(point_m.head<2>()) + 0.05;
            }));
        }
        for (const Plant& plant : world.plants) {
            const Vec3& base_m = plant.base_in_map_m;
            const double ground_m = world.terrain.height_m(base_m.head<2>());
            QVERIFY(base_m.z() <= ground_m && base_m.z() > ground_m - 1.5);
            QVERIFY(!world.water || ground_m > world.water->surface_z_m);
        }
    }

    void seedsMakeTheWorld_data() { addWorlds(); }
    void seedsMakeTheWorld() {
        QFETCH(const QString, name);
        QFETCH(const int, seed);
        const World& world = madeWorld(name.toStdString(), seed);
        QVERIFY(makeWorld(name.toStdString(), static_cast<std::uint64_t>(seed), {}) == world);
        const World& other = madeWorld(name.toStdString(), seed % made_seeds + 1);
        QVERIFY(world.boxes != other.boxes);
        QVERIFY(name == "warehouse" || world.terrain != other.terrain);
        QVERIFY(name == "warehouse" || world.plants != other.plants);
    }

    void everyStartIsReachable_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("seed");
        for (const char* name : {"town", "quarry"})
            for (int seed = 1; seed <= made_seeds; ++seed)
                QTest::addRow("%s %d", name, seed) << QString(name) << seed;
    }
    void everyStartIsReachable() {
        QFETCH(const QString, name);
        QFETCH(const int, seed);
        const World& world = madeWorld(name.toStdString(), seed);
        const Reach reach(world, startOf(world, "PlayerStart").head<2>());
        for (const NamedPose& start : world.start_poses)
            QVERIFY2(reach.contains(start.pose_in_map.position_m.head<2>()), start.name.c_str());
    }

private:
    static void addWorlds() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("seed");
        for (const char* name : {"warehouse", "town", "quarry"})
            for (int seed = 1; seed <= made_seeds; ++seed)
                QTest::addRow("%s %d", name, seed) << QString(name) << seed;
    }
};

USAR_TEST(tst_MadeWorlds)

} // namespace tst_made_worlds

#include "tst_made_worlds.moc"
