#include <QObject>
#include <QString>
#include <QTest>

#include <set>

#include "core/base/random.h"
#include "core/sim/rays/body_index.h"
#include "tests/suite/suite.h"

namespace tst_body_index {

using namespace usar;
using namespace usar::sim;

class tst_BodyIndex : public QObject {
    Q_OBJECT
private slots:
    void missesNoSphere_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("span_m");
        QTest::newRow("one") << 1 << 1.0;
        QTest::newRow("a few in a room") << 5 << 3.0;
        QTest::newRow("many on a field") << 200 << 100.0;
        QTest::newRow("one that fell off the world") << 20 << 1e5;
    }
    void missesNoSphere() {
        QFETCH(const int, count);
        QFETCH(const double, span_m);
        Random random = seeded(11, static_cast<std::uint64_t>(count));
        const auto anywhere = [&] {
            return Vec3(uniform(random, -span_m, span_m), uniform(random, -span_m, span_m), uniform(random, -3.0, 3.0));
        };
        for (int round = 0; round < 50; ++round) {
            std::vector<BodySphere> spheres;
            for (int i = 0; i < count; ++i)
                spheres.push_back({anywhere(), uniform(random, 0.05, 1.5), static_cast<std::uint32_t>(i)});
            BodyIndex index;
            index.build(spheres);
            for (int k = 0; k < 100; ++k) {
                // Half of them along an axis, straight down or from within a sphere: where grids go wrong.
                Vec3 direction = Vec3(gaussian(random, 1.0), gaussian(random, 1.0), gaussian(random, 0.3)).normalized();
                if (k % 4 == 0)
                    direction = -Vec3::UnitZ();
                else if (k % 4 == 1)
                    direction = Vec3::Unit(k / 4 % 2) * (k % 8 < 4 ? 1.0 : -1.0);
                const Vec3 origin_m = k % 3 == 0 ? spheres[static_cast<std::size_t>(k % count)].center_m : anywhere();
                const double maximum_m = uniform(random, 0.5, 3.0 * span_m);
                std::set<std::uint32_t> seen;
                index.along({origin_m, direction}, maximum_m, [&](const BodySphere& sphere, double nearest_m) {
                    seen.insert(sphere.piece);
                    return nearest_m;
                });
                for (const BodySphere& sphere : spheres) {
                    const Vec3 toward_m = sphere.center_m - origin_m;
                    const double closest_m = std::clamp(toward_m.dot(direction), 0.0, maximum_m);
                    if ((toward_m - closest_m * direction).norm() < sphere.radius_m - 1e-9)
                        QVERIFY2(seen.contains(sphere.piece),
                                 qPrintable(QString("round %1, ray %2").arg(round).arg(k)));
                }
            }
        }
    }

    void looksAtFewOfMany() {
        std::vector<BodySphere> spheres;
        for (std::uint32_t i = 0; i < 200; ++i)
            spheres.push_back({Vec3(10.0 * (i % 20), 12.0 * (i / 20), 3.0), 0.6, i});
        BodyIndex index;
        index.build(spheres);
        int visits = 0;
        const double nearest_m =
            index.along({Vec3(-5.0, 0.0, 3.0), Vec3::UnitX()}, 1000.0, [&](const BodySphere&, double) {
                ++visits;
                return 4.4; // the first one is hit: nothing behind it matters
            });
        QCOMPARE(nearest_m, 4.4);
        QVERIFY(visits <= 2);
    }

    void bodiesThatAreNowhereAreLeftOut() {
        BodyIndex index;
        index.build({{Vec3::Constant(std::nan("")), 1.0, 0}, {Vec3(3.0, 0.0, 0.0), 1.0, 1}});
        int visits = 0;
        const auto count = [&](const BodySphere& sphere, double nearest_m) {
            visits += sphere.piece == 1 ? 1 : 100;
            return nearest_m;
        };
        index.along({Vec3::Zero(), Vec3::UnitX()}, 10.0, count);
        QVERIFY(visits >= 1 && visits < 100);
        index.build({});
        QCOMPARE(index.along({Vec3::Zero(), Vec3::UnitX()}, 10.0, count), 10.0);
    }
};

USAR_TEST(tst_BodyIndex)

} // namespace tst_body_index

#include "tst_body_index.moc"
