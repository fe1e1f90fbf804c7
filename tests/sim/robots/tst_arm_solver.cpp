// Inverse kinematics: what can be reached is reached, and what cannot is said.
#include <cmath>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/base/random.h"
#include "core/sim/robots/arm_solver.h"
#include "core/sim/robots/robot_body.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_arm_solver {

using namespace usar;
using namespace usar::sim;

namespace {

const RobotModel& robotNamed(const char* name) {
    return *findRobot(*doubles::shippedRobots(), name);
}

/// Any posture within the limits.
std::vector<double> anyPosture(const RobotModel& model, Random& random) {
    std::vector<double> all(model.links.size(), 0.0);
    for (const std::string& joint : model.packages.front().joints) {
        const auto link = static_cast<std::size_t>(model.linkOnJoint(joint).value());
        const LinkDescription& part = model.body.links[link];
        all[link] = part.lower <= part.upper ? uniform(random, part.lower, part.upper) : uniform(random, -pi, pi);
    }
    return all;
}

} // namespace

class tst_ArmSolver : public QObject {
    Q_OBJECT

private slots:
    void reachesWhereAnyPostureIs_data() {
        QTest::addColumn<bool>("turned");
        QTest::newRow("TeleMax") << false;
        QTest::newRow("P2DX") << false;
        QTest::newRow("KR60") << false;
        QTest::newRow("KR60 ") << true;
    }
    void reachesWhereAnyPostureIs() {
        QFETCH(const bool, turned);
        const RobotModel& model = robotNamed(qPrintable(QString(QTest::currentDataTag()).trimmed()));
        const ArmSolver solver(model, model.packages.front());
        Random random = seeded(1, 2);
        int reached = 0;
        constexpr int tries = 200;
        for (int i = 0; i < tries; ++i) {
            const Eigen::Isometry3d goal = solver.tipInBase(anyPosture(model, random));
            TipTarget target{goal.translation(), {}};
            if (turned)
                target.rotation_in_base = Eigen::Quaterniond(goal.linear());
            std::vector<double> all = anyPosture(model, random);
            const ArmSolution found = solver.solve(target, all);
            reached += found.reached() ? 1 : 0;
            // What it says is what its positions give, and within the limits.
            const auto& joints = model.packages.front().joints;
            for (std::size_t k = 0; k < joints.size(); ++k) {
                const auto link = static_cast<std::size_t>(model.linkOnJoint(joints[k]).value());
                all[link] = found.positions[k];
                const LinkDescription& part = model.body.links[link];
                QVERIFY(part.lower > part.upper ||
                        (found.positions[k] >= part.lower && found.positions[k] <= part.upper));
            }
            QVERIFY(std::abs((solver.tipInBase(all).translation() - target.position_in_base_m).norm() - found.off_m) <
                    1e-9);
        }
        qInfo("%d of %d", reached, tries);
        QVERIFY(reached >= tries * 95 / 100);
    }

    void saysHowFarWhatItCannotReachIs() {
        const RobotModel& model = robotNamed("TeleMax");
        const ArmSolver solver(model, model.packages.front());
        const std::vector<double> folded(model.links.size(), 0.0);
        const ArmSolution far = solver.solve({{5.0, 0.0, 0.3}, {}}, folded);
        QVERIFY(!far.reached());
        // Shoulder at x = 0.18 m; upper arm 0.4 m; from the elbow to the tip 0.07 m up and 0.53 m forward.
        const double longest_m = 0.4 + std::hypot(0.53, 0.07);
        const double distance_m = Vec3(5.0 - 0.18, 0.0, 0.3 - 0.25).norm();
        QVERIFY2(std::abs(far.off_m - (distance_m - longest_m)) < 0.01, qPrintable(QString::number(far.off_m)));
        // The place alone can be reached, but not with the hand turned about its own axis.
        const ArmSolution place = solver.solve({{0.65, 0.0, 0.0}, {}}, folded);
        QVERIFY(place.reached());
        const ArmSolution turned =
            solver.solve({{0.65, 0.0, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Vec3::UnitX()))}, folded);
        QVERIFY(!turned.reached() && turned.off_rad > 0.1);
    }

    /// The kinematics of the solver are those of the physics.
    void itsTipIsThePhysics() {
        const RobotModel& model = robotNamed("TeleMax");
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        RobotBody body(*physics, model, Pose{{0.0, 0.0, 1.0}});
        std::vector<double> all(model.links.size(), 0.0);
        const std::vector<double> wanted{0.3, 1.2, 0.9};
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const auto link = static_cast<std::size_t>(model.linkOnJoint(model.packages[0].joints[i]).value());
            physics->setMotor(body.id(), link, {JointMotor::Mode::Position, wanted[i], 300.0, 1.0});
        }
        for (int i = 0; i < 1500; ++i)
            physics->step(physics_dt);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = body.joint(static_cast<int>(i)).position;
        const int last = model.linkOnJoint("ArmElbow").value();
        const Vec3 tip_m = body.link_in_map(last) * *model.packages[0].tip_in_last_link_m;
        const Vec3 solved_m =
            body.base_in_map().isometry() * ArmSolver(model, model.packages[0]).tipInBase(all).translation();
        QVERIFY2((tip_m - solved_m).norm() < 1e-6, qPrintable(QString::number((tip_m - solved_m).norm())));
    }
};

USAR_TEST(tst_ArmSolver)

} // namespace tst_arm_solver

#include "tst_arm_solver.moc"
