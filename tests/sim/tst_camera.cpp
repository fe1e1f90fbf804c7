// Pictures of cameras against what geometry says must be in them.
#include <cmath>

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>
#include <QTest>

#include "core/sim/camera/picture.h"
#include "core/sim/camera/renderer.h"
#include "core/sim/camera/scene_capture.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_camera {

using namespace usar;
using namespace usar::sim;

namespace {

const Color red{1.0f, 0.0f, 0.0f};

CameraScene sceneOf(World world) {
    CameraScene scene;
    scene.still = std::make_shared<const StillWorld>(std::move(world));
    return scene;
}

SeenFrom cameraAt(const Pose& camera_in_map, double field_of_view_rad = radians(80.0)) {
    SeenFrom camera;
    camera.camera_in_map = camera_in_map.isometry();
    camera.field_of_view_rad = field_of_view_rad;
    camera.width_px = 160;
    camera.height_px = 120;
    return camera;
}

void addBall(CameraScene& scene, const Vec3& center_m, double radius_m) {
    const Eigen::Isometry3d at(Eigen::Translation3d{center_m});
    scene.solids.push_back(seenSolid(SphereShape{radius_m}, at, red));
}

bool isRed(const Picture& picture, int x, int y) {
    const auto [r, g, b] = picture.pixel(x, y);
    return r > 30 && r > 3 * g && r > 3 * b;
}

int redPixels(const Picture& picture) {
    int count = 0;
    for (int y = 0; y < picture.height_px; ++y)
        for (int x = 0; x < picture.width_px; ++x)
            count += isRed(picture, x, y);
    return count;
}

double brightness(const Picture& picture, int x, int y) {
    const auto [r, g, b] = picture.pixel(x, y);
    return (r + g + b) / 3.0;
}

/// So far from the air's own color, at a camera that looks at a red wall from there.
double contrastAt(double distance_m) {
    CameraScene scene = sceneOf(flatWorld());
    scene.solids.push_back(
        seenSolid(BoxShape{{1.0, 400.0, 400.0}}, Pose{{distance_m + 0.5, 0.0, 0.0}}.isometry(), red));
    const auto [r, g, b] = render(scene, cameraAt({{0.0, 0.0, 60.0}})).pixel(80, 60);
    return 0.81 * 255.0 - g; // the haze's green; the wall has none
}

/// A robot whose camera looks ahead, over flat ground with a tower at its left.
std::unique_ptr<Simulation> robotByTower() {
    World world = flatWorld();
    world.boxes.push_back({Pose{{6.0, 6.0, 3.0}}, {2.0, 2.0, 6.0}});
    return simulationOf(std::move(world));
}

Picture pictureOf(const Simulation& simulation) {
    const CameraScene scene = simulation.cameraScene();
    return render(scene, scene.cameras.front());
}

double difference(const Picture& a, const Picture& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        sum += std::abs(a.rgb[i] - b.rgb[i]);
    return sum / static_cast<double>(a.rgb.size());
}

} // namespace

class tst_Camera : public QObject {
    Q_OBJECT

private slots:
    void aBallsOutlineIsWhereThePinholeSaysItIs_data() {
        QTest::addColumn<double>("left_m");
        QTest::addColumn<double>("up_m");
        QTest::addColumn<double>("fov_deg");
        QTest::newRow("straight ahead") << 0.0 << 0.0 << 80.0;
        QTest::newRow("to the left") << 2.0 << 0.0 << 80.0;
        QTest::newRow("to the right and above") << -2.5 << 1.5 << 80.0;
        QTest::newRow("seen through a long lens") << 0.5 << 0.0 << 20.0;
    }
    void aBallsOutlineIsWhereThePinholeSaysItIs() {
        QFETCH(double, left_m);
        QFETCH(double, up_m);
        QFETCH(double, fov_deg);
        CameraScene scene = sceneOf(flatWorld());
        const Vec3 center_m{8.0, left_m, 20.0 + up_m};
        const double radius_m = 0.7;
        addBall(scene, center_m, radius_m);
        const SeenFrom camera = cameraAt({{0.0, 0.0, 20.0}}, radians(fov_deg));
        const Picture picture = render(scene, camera);
        const double pixel = 2.0 * std::tan(radians(fov_deg) / 2.0) / camera.width_px;
        int wrong = 0;
        for (int y = 0; y < picture.height_px; ++y)
            for (int x = 0; x < picture.width_px; ++x) {
                const Vec3 ray = Vec3{1.0, (80.0 - x - 0.5) * pixel, (60.0 - y - 0.5) * pixel}.normalized();
                const Vec3 to_center = center_m - Vec3{0.0, 0.0, 20.0};
                const double miss_m = (to_center - to_center.dot(ray) * ray).norm();
                wrong += isRed(picture, x, y) != (miss_m < radius_m);
            }
        QVERIFY(redPixels(picture) > 20);
        QCOMPARE(wrong, 0);
    }

    void whatStandsBehindAHillIsHidden() {
        CameraScene scene =
            sceneOf(groundOf([](const Vec2& at_m) { return at_m.x() > 4.0 && at_m.x() < 8.0 ? 5.0 : 0.0; }));
        addBall(scene, {12.0, 0.0, 1.0}, 0.8);
        QCOMPARE(redPixels(render(scene, cameraAt({{0.0, 0.0, 1.0}}))), 0);
        QVERIFY(redPixels(render(scene, cameraAt({{20.0, 0.0, 1.0}, 0.0, 0.0, pi}))) > 50);
    }

    void theCamerasOwnHousingIsNotSeen() {
        CameraScene scene = sceneOf(flatWorld());
        addBall(scene, {0.0, 0.0, 2.0}, 0.3);
        QCOMPARE(redPixels(render(scene, cameraAt({{0.05, 0.0, 2.0}}))), 0);
    }

    void leavesAreGreenAndTrunksAreBrown() {
        World world = flatWorld();
        world.plants.push_back({{8.0, 0.0, 0.0}, 0.4, 4.0, CrownShape::Sphere, 1.5, 0.0});
        const Picture picture = render(sceneOf(std::move(world)), cameraAt({{0.0, 0.0, 2.0}}));
        const auto crown = picture.pixel(80, 41); // 4 m up, 8 m away: 23.8 pixels above the middle
        const auto trunk = picture.pixel(80, 60);
        QVERIFY2(crown[1] > crown[0] && crown[1] > crown[2] + 20, "crown");
        QVERIFY2(trunk[0] > trunk[1] && trunk[1] > trunk[2], "trunk");
    }

    void waterIsSeenThoughNoRangeSensorMeetsIt() {
        World wet = groundOf([](const Vec2&) { return -4.0; });
        const CameraScene dry_scene = sceneOf(wet);
        wet.water = Water{0.0};
        const CameraScene wet_scene = sceneOf(wet);
        const SeenFrom down = cameraAt({{0.0, 0.0, 3.0}, 0.0, radians(60.0), 0.0});
        const auto dry = render(dry_scene, down).pixel(80, 60);
        const auto water = render(wet_scene, down).pixel(80, 60);
        QVERIFY(dry[1] > dry[2]);
        QVERIFY2(water[2] > water[0] + 20, "water is blue");
        QCOMPARE(wet_scene.still->caster.cast({0.0, 0.0, 3.0}, -Vec3::UnitZ(), 20.0), 7.0);
    }

    void shallowWaterLetsTheGroundThrough() {
        World world = groundOf([](const Vec2& at_m) { return at_m.x() > 0.0 ? -0.2 : -20.0; });
        world.water = Water{0.0};
        const Picture picture = render(sceneOf(std::move(world)), cameraAt({{0.0, 0.0, 6.0}, 0.0, radians(90.0), 0.0}));
        const auto shallow = picture.pixel(80, 20); // the camera looks down: ahead is up in the picture
        const auto deep = picture.pixel(80, 100);
        QVERIFY(shallow[0] > 2 * deep[0]);
    }

    void hazeGrowsWithDistanceAsTheLawOfTheAirSays() {
        const double near = contrastAt(26.0);
        const double far = contrastAt(260.0);
        const double farther = contrastAt(520.0);
        QVERIFY(near > far && far > farther);
        QVERIFY(std::abs(far / near - std::exp(-0.9)) < 0.03);
        QVERIFY(std::abs(farther / far - std::exp(-1.0)) < 0.04);
    }

    void whatLiesInShadeIsDarker() {
        World world = flatWorld();
        world.boxes.push_back({Pose{{-4.0, -3.0, 3.0}}, {3.0, 3.0, 6.0}});
        const Picture picture =
            render(sceneOf(std::move(world)), cameraAt({{0.0, 0.0, 14.0}, 0.0, radians(90.0), 0.0}));
        QVERIFY(brightness(picture, 80, 66) < 0.75 * brightness(picture, 80, 20));
    }

    void aHeadlightBrightensWhatItShinesOn() {
        CameraScene scene = sceneOf(flatWorld());
        scene.solids.push_back(
            seenSolid(BoxShape{{1.0, 40.0, 10.0}}, Pose{{6.0, 0.0, 0.0}}.isometry(), Color::Constant(0.4f)));
        const SeenFrom camera = cameraAt({{0.0, 0.0, 1.0}});
        const Picture dark = render(scene, camera);
        scene.lamps.push_back({{0.0, 0.0, 1.0}, Vec3::UnitX()});
        const Picture bright = render(scene, camera);
        QVERIFY(brightness(bright, 80, 60) > 1.3 * brightness(dark, 80, 60));
        QCOMPARE(brightness(bright, 5, 60), brightness(dark, 5, 60)); // beside its cone
    }

    void theSameSceneGivesTheSamePicture() {
        CameraScene scene = sceneOf(flatWorld());
        addBall(scene, {8.0, 1.0, 2.0}, 1.0);
        const SeenFrom camera = cameraAt({{0.0, 0.0, 2.0}});
        QCOMPARE(render(scene, camera), render(scene, camera));
    }

    void zoomOfTheBotPortNarrowsThePicture() {
        const auto simulation = robotByTower();
        Talker talker(*simulation);
        talker.say(init_p2dx);
        steps(*simulation, 20);
        const Picture wide = pictureOf(*simulation);
        talker.say("SET {Type Camera} {Name Camera} {Opcode Zoom} {Params 0.5}");
        steps(*simulation, 2);
        const CameraScene scene = simulation->cameraScene();
        QCOMPARE(scene.cameras.front().field_of_view_rad, 0.5);
        QVERIFY(difference(wide, render(scene, scene.cameras.front())) > 2.0);
    }

    void panAndTiltTurnTheCamera() {
        const auto simulation = robotByTower();
        Talker talker(*simulation);
        talker.say(init_p2dx);
        steps(*simulation, 20);
        const Picture ahead = pictureOf(*simulation);
        talker.say(
            "MISPKG {Name CameraPanTilt} {Link 1} {Value -0.8} {Link 2} {Value 0.3}"); // the wire: right is positive
        steps(*simulation, 20);
        const CameraScene scene = simulation->cameraScene();
        const Vec3 looks = scene.cameras.front().camera_in_map.linear() * Vec3::UnitX();
        QVERIFY2(std::abs(std::atan2(looks.y(), looks.x()) - 0.8) < 0.05, qPrintable(QString::number(looks.y())));
        QVERIFY(std::abs(std::asin(looks.z()) - 0.3) < 0.05);
        QVERIFY(difference(ahead, render(scene, scene.cameras.front())) > 2.0);
    }

    void anotherRobotIsSeen() {
        const auto simulation = simulationOf(flatWorld());
        Talker first(*simulation);
        first.say(init_p2dx);
        steps(*simulation, 20);
        const Picture alone = pictureOf(*simulation);
        Talker second(*simulation);
        second.say("INIT {ClassName USARBot.P2AT} {Name R2} {Location 3,0,-0.2}");
        steps(*simulation, 20);
        QVERIFY(difference(alone, pictureOf(*simulation)) > 0.3);
    }

    void theWindowShowsTheOnlyCameraOrFourOfSeveralOrWhoWatches() {
        const auto simulation = simulationOf(flatWorld());
        const Picture nobody = windowPicture(simulation->cameraScene());
        QCOMPARE(nobody.width_px, 320);
        Talker first(*simulation);
        Talker second(*simulation);
        first.say(init_p2dx);
        steps(*simulation, 5);
        QCOMPARE(windowPicture(simulation->cameraScene()), pictureOf(*simulation));
        second.say("INIT {ClassName USARBot.P2AT} {Name R2} {Location 3,0,-0.2}");
        steps(*simulation, 5);
        const CameraScene both = simulation->cameraScene();
        const Picture quad = windowPicture(both);
        QCOMPARE(quad.width_px, 640);
        QCOMPARE(quad.height_px, 480);
        QCOMPARE(cut(quad, 320, 0, 320, 240), render(both, both.cameras[1]));
        const CameraChoice choice{"r2", ""};
        QCOMPARE(windowPicture(both, &choice), render(both, both.cameras[1]));
    }

    void aViewerIsAttachedToACameraByTheBotPort() {
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        talker.say(init_p2dx);
        steps(*simulation, 2);
        talker.say("SET {Type Camera} {Robot R1} {Name Camera} {Client 127.0.0.1}");
        steps(*simulation, 1);
        QCOMPARE(simulation->cameraScene().attached.at("127.0.0.1"), (CameraChoice{"R1", "Camera"}));
        const auto lines = talker.hearText();
        QVERIFY(std::ranges::any_of(lines, [](const std::string& line) {
            return line.starts_with("RES ") && line.find("{Type Camera}") != std::string::npos &&
                   line.find("{Status OK}") != std::string::npos;
        }));
        talker.say("SET {Type Camera} {Client 127.0.0.1}");
        steps(*simulation, 1);
        QVERIFY(simulation->cameraScene().attached.empty());
        talker.say("SET {Type Camera} {Robot R9} {Name Camera} {Client 127.0.0.1}");
        steps(*simulation, 1);
        QVERIFY(simulation->cameraScene().attached.empty());
    }

    void aClientSaysWhatTheWindowShows() {
        const auto simulation = simulationOf(flatWorld());
        Talker first(*simulation);
        Talker second(*simulation);
        first.say(init_p2dx);
        second.say("INIT {ClassName USARBot.P2AT} {Name R2} {Location 3,0,-0.2}");
        steps(*simulation, 5);
        const auto answerTo = [&](Talker& who, const std::string& line) {
            who.hearText();
            who.say(line);
            steps(*simulation, 1);
            for (const std::string& heard : who.hearText())
                if (heard.starts_with("RES "))
                    return heard.substr(heard.find("{Type"));
            return std::string("no answer");
        };
        QCOMPARE(answerTo(second, "SET {Type Viewports} {Config SingleView} {Viewport1 Camera}"),
                 std::string("{Type Viewports} {Config SingleView} {Status OK} {Viewport1 Camera} {Status OK}"));
        CameraScene scene = simulation->cameraScene();
        QCOMPARE(windowPicture(scene), render(scene, scene.cameras[1]));

        QCOMPARE(answerTo(first, "SET {Type Viewports} {Config QuadView} {Viewport1 Disabled} {Viewport2 camera} "
                                 "{Viewport3 None} {Viewport4 RearCam}"),
                 std::string("{Type Viewports} {Config QuadView} {Status OK} {Viewport1 Disabled} {Status OK} "
                             "{Viewport2 camera} {Status OK} {Viewport3 None} {Status OK} {Viewport4 RearCam} "
                             "{Status Failed}"));
        scene = simulation->cameraScene();
        const Picture four = windowPicture(scene);
        QCOMPARE(four.width_px, 640);
        QCOMPARE(cut(four, 320, 0, 320, 240), render(scene, scene.cameras[0]));
        QCOMPARE(cut(four, 0, 0, 320, 240), Picture(320, 240));
        QCOMPARE(cut(four, 0, 240, 640, 240), Picture(640, 240));

        // What is not named stays as it was; who is attached to a camera sees that one.
        answerTo(second, "SET {Type Viewports} {Config QuadView} {Viewport3 Camera}");
        scene = simulation->cameraScene();
        QCOMPARE(cut(windowPicture(scene), 320, 0, 320, 240), render(scene, scene.cameras[0]));
        QCOMPARE(cut(windowPicture(scene), 0, 240, 320, 240), render(scene, scene.cameras[1]));
        const CameraChoice choice{"R2", ""};
        QCOMPARE(windowPicture(scene, &choice), render(scene, scene.cameras[1]));
    }

    void aWindowWhoseCamerasHaveGoneIsItsUsualSelf() {
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        talker.say(init_p2dx);
        steps(*simulation, 2);
        talker.say("SET {Type Viewports} {Config QuadView} {Viewport1 Camera}");
        steps(*simulation, 1);
        QCOMPARE(windowPicture(simulation->cameraScene()).width_px, 640);
        simulation->disconnect(talker.id());
        QCOMPARE(windowPicture(simulation->cameraScene()).width_px, 320);
    }

    void aPartOfAPictureStaysInsideIt() {
        Picture whole(4, 3);
        for (int i = 0; i < 12; ++i)
            whole.rgb[static_cast<std::size_t>(3 * i)] = static_cast<std::uint8_t>(i);
        const Picture part = cut(whole, 2, 1, 100, 1);
        QCOMPARE(part.width_px, 2);
        QCOMPARE(part.pixel(0, 0)[0], 6);
        QCOMPARE(cut(whole, 4294967295, 4294967295, 0, 0).width_px, 1);
    }

    void aJpegReadsBackAsThePicture() {
        CameraScene scene = sceneOf(flatWorld());
        addBall(scene, {8.0, 0.0, 2.0}, 1.5);
        const Picture picture = render(scene, cameraAt({{0.0, 0.0, 2.0}}));
        const std::string file = jpegOf(picture, 75);
        const QImage read =
            QImage::fromData(reinterpret_cast<const uchar*>(file.data()), static_cast<int>(file.size()));
        QCOMPARE(read.size(), QSize(160, 120));
        QVERIFY(qRed(read.pixel(80, 60)) > 2 * qGreen(read.pixel(80, 60)));
        QVERIFY(std::abs(qBlue(read.pixel(10, 5)) - picture.pixel(10, 5)[2]) < 12);
        QVERIFY(jpegOf(picture, 25).size() < jpegOf(picture, 100).size() / 2);
    }
};

USAR_TEST(tst_Camera)

} // namespace tst_camera

#include "tst_camera.moc"
