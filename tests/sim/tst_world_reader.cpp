#include "core/sim/world/world_reader.h"

#include <algorithm>
#include <cmath>

#include <QObject>
#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include "core/sim/world/height_png.h"
#include "core/sim/world/world_writer.h"
#include "tests/doubles/test_files.h"
#include "tests/doubles/test_worlds.h"
#include "tests/suite/suite.h"

namespace tst_world_reader {

using namespace usar;
using namespace usar::sim;
using doubles::pathOf;
using doubles::readAll;
using doubles::writeAll;

namespace {

WorldObject ball() {
    WorldObject ball{.name = "ball", .class_name = "USARModels.SoccerBall", .body = {}, .body_in_map = {}};
    ball.body = {.mass_kg = 0.06,
                 .inertia_kg_m2 = Vec3::Constant(7.4e-5),
                 .friction = 0.5,
                 .parts = {{SphereShape{0.043}, {}}},
                 .restitution = 0.6,
                 .rolling_friction_m = 0.001};
    ball.body_in_map.position_m = {2.0, 0.5, 0.043};
    return ball;
}

/// Of all shapes that there are.
WorldObject barrow() {
    WorldObject barrow{.name = "bar & row", .class_name = "", .body = {}, .body_in_map = {}};
    barrow.body.mass_kg = 12.0;
    barrow.body.inertia_kg_m2 = {0.8, 1.0, 1.2};
    barrow.body.parts = {{BoxShape{{0.8, 0.5, 0.3}}, {}},
                         {CylinderShape{0.2, 0.05}, {.position_m = {0.5, 0.0, -0.1}, .roll_rad = 0.5}},
                         {CapsuleShape{0.02, 0.6}, {.position_m = {-0.5, 0.25, 0.0}, .pitch_rad = 0.25}}};
    barrow.body_in_map = {.position_m = {-4.0, 3.0, 1.0}, .yaw_rad = 0.75};
    return barrow;
}

/// 17 x 17 posts with heights in steps that files keep.
World smallWorld() {
    World world = doubles::woodedWorld(9, 12, 32.0);
    world.name = "small & <odd>";
    world.terrain = doubles::terrainOf(17, 2.0, [](double x, double y) { return x / 8.0 + y * y / 64.0 - 3.0; });
    world.boxes = {{{.position_m = {4.0, -5.0, 1.5}, .yaw_rad = 0.4}, {3.0, 5.0, 3.0}}};
    world.objects = {ball(), barrow()};
    world.rfid_tags = {{7, "exit <left> & \"up\"", {1.0, 2.0, 0.25}}, {0, "", {-1.0, 0.1, 0.0}}};
    world.victims = {
        {"Becky", "Calm", {{VictimPartKind::Head, {3.0, 1.0, 0.5}}, {VictimPartKind::Foot, {4.5, 1.0, 0.1}}}},
        {"Sam", "", {{VictimPartKind::Hand, {-3.0, 1.5, 0.5}}}}};
    world.sounds = {{"alarm", 82.5, {0.0, -4.0, 2.0}}};
    world.gases = {{"CO2", 0.04, {3.0, 1.0, 0.6}}};
    world.gps_reference = {-36.8764, 174.7647};
    world.water = Water{.surface_z_m = -2.5, .density_kg_m3 = 1025.0};
    world.start_poses = {{"PlayerStart", {.position_m = {1.0, 2.0, 0.5}, .yaw_rad = 1.25}},
                         {"Second \"place\"", {.position_m = {-3.0, 0.0, 0.0}, .roll_rad = 0.1, .pitch_rad = -0.2}}};
    return world;
}

/// A row: a world file with `to` in place of `from`, and a part of what the reader says about it.
void broken(const char* row, const char* from, const char* to, const char* word = "") {
    QTest::newRow(row) << std::string(from) << std::string(to) << std::string(word);
}

} // namespace

class tst_WorldReader : public QObject {
    Q_OBJECT

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        world_ = smallWorld();
        QVERIFY(writeWorld(world_, folder()));
    }

    void readsBackWhatWasWritten() {
        const auto read = readWorld(folder());
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QCOMPARE(read->name, world_.name);
        QVERIFY(read->terrain.heights_m() == world_.terrain.heights_m());
        QCOMPARE(read->terrain.extent(), world_.terrain.extent());
        QVERIFY(read->plants == world_.plants);
        QVERIFY(read->water == world_.water);
        QVERIFY(read->start_poses == world_.start_poses);
        QVERIFY(read->rfid_tags == world_.rfid_tags);
        QVERIFY(read->victims == world_.victims);
        QVERIFY(read->sounds == world_.sounds);
        QVERIFY(read->gases == world_.gases);
        QVERIFY(read->gps_reference == world_.gps_reference);
        QCOMPARE(read->boxes.size(), std::size_t{1});
        QVERIFY(read->boxes[0].size_m == world_.boxes[0].size_m);
        QVERIFY(read->boxes[0].center_in_map.isometry().isApprox(world_.boxes[0].center_in_map.isometry(), 1e-12));
        QCOMPARE(read->objects.size(), std::size_t{2});
        QVERIFY(read->objects[0] == world_.objects[0]);
        // Angles go through quaternions; but for their last bits it is the same world.
        auto same = *read;
        same.boxes = world_.boxes;
        WorldObject& object = same.objects[1];
        const WorldObject& written = world_.objects[1];
        QVERIFY(object.body_in_map.isometry().isApprox(written.body_in_map.isometry(), 1e-12));
        object.body_in_map = written.body_in_map;
        for (std::size_t i = 0; i < object.body.parts.size(); ++i) {
            Pose& part_in_body = object.body.parts[i].part_in_body;
            QVERIFY(part_in_body.isometry().isApprox(written.body.parts[i].part_in_body.isometry(), 1e-12));
            part_in_body = written.body.parts[i].part_in_body;
        }
        QVERIFY(same == world_);
    }

    void northIsTheTopOfThePicture() {
        const auto image = readHeightPng(folder() / "height.png");
        QVERIFY(image);
        // Lowest y and highest x of the ground: lower right corner of the picture.
        const double corner_m = -5.0 + image->values[16 * 17 + 16] / 1024.0;
        QVERIFY(std::abs(world_.terrain.height_m({16.0, -16.0}) - corner_m) < 1e-9);
    }

    void posesOfModelLinkAndCollisionAddUp() {
        replace("<model name=\"buildings\">\n      <static>true</static>\n      <link name=\"link\">",
                "<model name=\"buildings\">\n      <static>true</static>\n      <pose>3 -3 1 0 0 "
                "1.5707963267948966</pose>\n"
                "      <link name=\"link\"><pose>1 0 0 0 0 0</pose>");
        replace("<pose>4 -5 1.5 0 0 0.4</pose>", "<pose>0 1 0.5 0 0 0</pose>");
        const auto read = readWorld(folder());
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QVERIFY(read->boxes[0].center_in_map.position_m.isApprox(Vec3{2.0, -2.0, 1.5}, 1e-9));
    }

    void massesNeedNotSitInTheMiddleOfALink() {
        replace("<pose>2 0.5 0.043 0 0 0</pose>", "<pose>2 0.5 1 0 0 1.5707963267948966</pose>");
        replace("<inertial><mass>0.06", "<inertial><pose>0.1 0 0 0 0 0</pose><mass>0.06");
        const auto read = readWorld(folder());
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QVERIFY(read->objects[0].body_in_map.position_m.isApprox(Vec3{2.0, 0.6, 1.0}, 1e-9));
        QVERIFY(read->objects[0].body.parts[0].part_in_body.position_m.isApprox(Vec3{-0.1, 0.0, 0.0}, 1e-9));
    }

    void whatIsNotSaidOfASurfaceIsUsual() {
        replace("<bounce><restitution_coefficient>0.6</restitution_coefficient></bounce>", "");
        replace("<friction>0.5</friction><rolling_friction>0.001</rolling_friction>", "");
        const auto read = readWorld(folder());
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QCOMPARE(read->objects[0].body.friction, BodyDescription{}.friction);
        QCOMPARE(read->objects[0].body.restitution, 0.0);
        QCOMPARE(read->objects[0].body.rolling_friction_m, 0.0);
    }

    void aWorldWithoutPlantsOrWaterIsFine() {
        world_.plants.clear();
        world_.water.reset();
        QVERIFY(writeWorld(world_, folder()));
        const auto read = readWorld(folder());
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QVERIFY(read->plants.empty() && !read->water);
    }

    void refusesAndSaysWhere_data() {
        QTest::addColumn<std::string>("from");
        QTest::addColumn<std::string>("to");
        QTest::addColumn<std::string>("word");
        broken("posts not square", "<size>32 32", "<size>32 33", "size of the height map");
        broken("size zero", "<size>32 32", "<size>0 0", "size of the height map");
        broken("size missing", "<size>32 32", "<size>", "");
        broken("no picture of that name", "height.png", "other.png", "height map");
        broken("no table of that name", "plants.csv", "other.csv", "plants");
        broken("scatter without a file", "<usar:uri>plants.csv</usar:uri>", "", "usar:scatter");
        broken("start pose with five numbers", "1 2 0.5 0 0 1.25", "1 2 0.5 0 0", "usar:start_pose");
        broken("start pose with seven numbers", "1 2 0.5 0 0 1.25", "1 2 0.5 0 0 1 1", "usar:start_pose");
        broken("start pose with a word", "1 2 0.5 0 0 1.25", "1 2 0.5 0 0 east", "usar:start_pose");
        broken("start pose without a name", " name=\"PlayerStart\"", "", "usar:start_pose");
        broken("water without a surface", "<usar:surface_z>-2.5</usar:surface_z>", "", "usar:water");
        broken("water without weight", "1025", "0", "usar:water");
        broken("a box with words for sizes", "<size>3 5 3</size>", "<size>big</size>", "");
        broken("a shape that we cannot cast at", "<box><size>3 5 3</size></box>", "<sphere><radius>1</radius></sphere>",
               "neither a box");
        broken("two height maps", "<box><size>3 5 3</size></box>",
               "<heightmap><uri>height.png</uri><size>32 32 1</size></heightmap>", "two grounds");
        broken("a height map and a floor", "<box><size>3 5 3</size></box>", "<plane><size>10 10</size></plane>",
               "two grounds");
        broken("an element that nobody knows", "</world>", "<usar:treasure>1 2 3</usar:treasure></world>",
               "usar:treasure");
        broken("two start poses of one name", "</world>",
               "<usar:start_pose name=\"PlayerStart\">0 0 0 0 0 0</usar:start_pose></world>", "two start poses");
        broken("no start pose", "usar:start_pose name=\"PlayerStart\"", "usar:start_pose name=\"\"", "usar:start_pose");
        broken("two waters", "</world>",
               "<usar:water><usar:surface_z>1</usar:surface_z><usar:density>1000</usar:density></usar:water></world>",
               "second usar:water");
        broken("a box without size", "<size>3 5 3</size>", "<size>3 0 3</size>", "box without size");
        addBrokenTags();
        addBrokenSources();
        addBrokenThings();
    }
    void refusesAndSaysWhere() {
        QFETCH(std::string, from);
        QFETCH(std::string, to);
        QFETCH(std::string, word);
        replace(from, to);
        const auto read = readWorld(folder());
        QVERIFY(!read);
        QVERIFY2(read.error().what.find(word) != std::string::npos, read.error().text().c_str());
        QVERIFY(read.error().where.starts_with(folder().string()));
        QVERIFY(!read.error().mend.empty());
    }

    void refusesAWrongPicture() {
        writeAll(folder() / "height.png", "GIF89a");
        const auto read = readWorld(folder());
        QVERIFY(!read);
        QCOMPARE(read.error().where, (folder() / "height.png").string());
    }

    void refusesABadPlantWithItsLine() {
        writeAll(folder() / "plants.csv", readAll(folder() / "plants.csv") + "round,1,2\n");
        const auto read = readWorld(folder());
        QVERIFY(!read);
        QCOMPARE(read.error().where, (folder() / "plants.csv").string() + ":14");
    }

    void refusesMissingFolders_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("no folder") << QString("nowhere");
        QTest::newRow("a folder without a world") << QString("empty");
        QTest::newRow("a file") << QString("height.png");
    }
    void refusesMissingFolders() {
        QFETCH(QString, name);
        std::filesystem::create_directory(folder() / "empty");
        const auto read = readWorld(folder() / name.toStdString());
        QVERIFY(!read);
        QCOMPARE(read.error().where, (folder() / name.toStdString()).string());
        QVERIFY(!read.error().mend.empty());
    }

    void refusesEveryCutFile() {
        const std::string text = readAll(sdf());
        for (const std::size_t part : {0u, 1u, 2u, 3u}) {
            writeAll(sdf(), text.substr(0, text.size() * part / 4));
            const auto read = readWorld(folder());
            QVERIFY(!read);
            QVERIFY(read.error().where.starts_with(sdf().string()));
            QVERIFY(!read.error().what.empty() && !read.error().mend.empty());
        }
    }

    void namesTheLineOfBadSdf_data() {
        QTest::addColumn<std::string>("from");
        QTest::addColumn<std::string>("to");
        QTest::addColumn<std::string>("word");
        broken("a tag that is not closed", "<static>true</static>", "<static>true</model>");
        broken("a model without a name", "<model name=\"ground\">\n      <static>true</static>",
               "<model>\n      <static>true</static>");
        broken("a shape that we cannot cast at", "<box><size>3 5 3</size></box>",
               "<sphere><radius>1</radius></sphere>");
        broken("posts not square", "<size>32 32", "<size>32 33");
        broken("a tag in two dimensions", ">1 2 0.25<", ">1 2<");
        broken("the second tag, after a comment of two lines", "<usar:rfid_tag id=\"0\"",
               "<!-- <usar:rfid_tag\n--><usar:rfid_tag id=\"no\"");
        broken("a victim with a wing", "kind=\"Hand\"", "kind=\"Wing\"");
        broken("a water without weight", "1025", "0");
    }
    void namesTheLineOfBadSdf() {
        QFETCH(std::string, from);
        QFETCH(std::string, to);
        const std::string before = readAll(sdf());
        const auto at = static_cast<std::ptrdiff_t>(before.find(from));
        const auto broken_line = 1 + std::count(before.begin(), before.begin() + at, '\n');
        replace(from, to);
        const auto read = readWorld(folder());
        QVERIFY(!read);
        const std::string file_and_colon = sdf().string() + ":";
        QVERIFY2(read.error().where.starts_with(file_and_colon), read.error().text().c_str());
        const int line = std::stoi(read.error().where.substr(file_and_colon.size()));
        QVERIFY2(std::abs(line - broken_line) <= 1, read.error().text().c_str());
    }

    void refusesAnotherKindOfXml() {
        writeAll(sdf(), "<html></html>");
        const auto read = readWorld(folder());
        QVERIFY(!read);
        QCOMPARE(read.error().what, std::string("this is not SDFormat"));
    }

    void aFloorNeedsNoPicture_data() {
        QTest::addColumn<double>("width_m");
        QTest::addColumn<double>("depth_m");
        QTest::addColumn<double>("z_m");
        QTest::newRow("a square at zero") << 10.0 << 10.0 << 0.0;
        QTest::newRow("a hall") << 41.0 << 26.0 << 0.0;
        QTest::newRow("a cellar") << 6.5 << 4.25 << -3.5;
        QTest::newRow("a corridor upstairs") << 2.0 << 64.0 << 3.1;
    }
    void aFloorNeedsNoPicture() {
        QFETCH(double, width_m);
        QFETCH(double, depth_m);
        QFETCH(double, z_m);
        const Vec2 half_m = Vec2(width_m, depth_m) / 2.0;
        const auto floor = Terrain::level({-half_m, half_m}, z_m);
        QVERIFY(floor);
        world_.terrain = *floor;
        const QTemporaryDir other;
        QVERIFY(writeWorld(world_, pathOf(other)));
        QVERIFY(!std::filesystem::exists(pathOf(other) / "height.png"));
        const auto read = readWorld(pathOf(other));
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QVERIFY(read->terrain == world_.terrain);
        QCOMPARE(extentOf(*read), (Rectangle{-half_m, half_m}));
        QVERIFY(std::abs(read->terrain.height_m({0.3, 0.7}) - z_m) < 1e-6);
    }

    void boxesAloneAreAWorld() {
        world_.terrain = {};
        world_.plants.clear();
        const QTemporaryDir other;
        QVERIFY(writeWorld(world_, pathOf(other)));
        const auto read = readWorld(pathOf(other));
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QVERIFY(read->terrain.empty());
        // A box of 3 x 5 turned by 0.4 around (4, -5).
        const Vec2 reach_m(1.5 * std::cos(0.4) + 2.5 * std::sin(0.4), 1.5 * std::sin(0.4) + 2.5 * std::cos(0.4));
        QVERIFY(extentOf(*read).max_m.isApprox(Vec2(4.0, -5.0) + reach_m, 1e-9));
        QVERIFY(extentOf(*read).min_m.isApprox(Vec2(4.0, -5.0) - reach_m, 1e-9));
    }

    void steepLandIsKeptInWiderSteps_data() {
        QTest::addColumn<double>("slope");
        QTest::addColumn<double>("step_m");
        QTest::newRow("60 m fit 1/1024 m") << 60.0 / 8.0 << 1.0 / 1024.0;
        QTest::newRow("100 m need 1/512 m") << 100.0 / 8.0 << 1.0 / 512.0;
        QTest::newRow("200 m need 1/256 m") << 200.0 / 8.0 << 1.0 / 256.0;
        QTest::newRow("9 km need 1/4 m") << 9000.0 / 8.0 << 1.0 / 4.0;
    }
    void steepLandIsKeptInWiderSteps() {
        QFETCH(double, slope);
        QFETCH(double, step_m);
        world_.terrain = doubles::terrainOf(
            9, 1.0, [&](double x, double y) { return std::round((slope * x + 0.37 * y) / step_m) * step_m; });
        QVERIFY(writeWorld(world_, folder()));
        const auto read = readWorld(folder());
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QVERIFY(read->terrain == world_.terrain);
    }

    void writesNothingWithoutGround() {
        world_.terrain = {};
        world_.boxes.clear();
        const QTemporaryDir other;
        QVERIFY(!writeWorld(world_, pathOf(other) / "void"));
        QVERIFY(!std::filesystem::exists(pathOf(other) / "void"));
    }

    void writesNothingWithHeightsThatAreNoNumbers() {
        world_.terrain = doubles::terrainOf(9, 1.0, [](double x, double) { return x == 0.0 ? std::nan("") : 1.0; });
        const QTemporaryDir other;
        QVERIFY(!writeWorld(world_, pathOf(other) / "void"));
        QVERIFY(!std::filesystem::exists(pathOf(other) / "void"));
    }

private:
    static void addBrokenTags() {
        broken("a tag without a number", "id=\"7\"", "", "usar:rfid_tag");
        broken("a tag with a word for a number", "id=\"7\"", "id=\"seven\"", "usar:rfid_tag");
        broken("a tag with a number below zero", "id=\"7\"", "id=\"-7\"", "usar:rfid_tag");
        broken("a tag with a number beyond an int", "id=\"7\"", "id=\"7000000000\"", "usar:rfid_tag");
        broken("a tag in two dimensions", ">1 2 0.25<", ">1 2<", "usar:rfid_tag");
        broken("two tags with one number", "id=\"7\"", "id=\"0\"", "two tags with the id 0");
        broken("a victim without a name", "usar:victim name=\"Becky\"", "usar:victim", "usar:victim needs a name");
        broken("a victim with a wing", "kind=\"Hand\"", "kind=\"Wing\"", "Pelvis");
        broken("a victim with a part nowhere", ">4.5 1 0.1<", "><", "usar:part");
        broken("a victim with something else in it", "<usar:part kind=\"Foot\">4.5 1 0.1</usar:part>", "<usar:leg/>",
               "usar:part");
        broken("a victim without parts", "<usar:part kind=\"Hand\">-3 1.5 0.5</usar:part>", "",
               "\"Sam\" has no usar:part");
    }

    static void addBrokenSources() {
        broken("a sound without loudness", " loudness=\"82.5\"", "", "usar:sound");
        broken("an endless sound", "82.5", "inf", "usar:sound");
        broken("a sound without a name", " name=\"alarm\"", "", "usar:sound");
        broken("a sound nowhere", "0 -4 2<", "here<", "usar:sound");
        broken("a gas without a name", " gas=\"CO2\"", "", "usar:gas");
        broken("less than no gas", "density=\"0.04", "density=\"-0.04", "usar:gas");
        broken("a gas nowhere", "3 1 0.6<", "3 1 0.6 9<", "usar:gas");
        broken("a place beyond the pole", "-36.8764", "-96.8764", "usar:gps_reference");
        broken("a place without a longitude", " longitude=\"174.7647\"", "", "usar:gps_reference");
    }

    static void addBrokenThings() {
        broken("a thing without mass", "<inertial><mass>0.06</mass>", "<inertial><mass>0</mass>", "ball");
        broken("a thing without inertia", "<ixx>7.4e-05</ixx>", "<ixx>0</ixx>", "ball");
        broken("a thing of unknown mass",
               "<inertial><mass>0.06</mass><inertia><ixx>7.4e-05</"
               "ixx><iyy>7.4e-05</iyy><izz>7.4e-05</izz></inertia>"
               "</inertial>",
               "", "\"ball\" needs an inertial");
        broken("a thing whose inertia is askew", "<ixx>7.4e-05</ixx>", "<ixx>7.4e-05</ixx><ixy>1e-05</ixy>",
               "main axes");
        broken("a thing of an unknown shape", "<sphere><radius>0.043</radius></sphere>",
               "<plane><size>1 1</size></plane>", "\"ball\" has a shape");
        broken("a thing inside out", "<radius>0.043", "<radius>-0.043", "\"ball\" has a shape without size");
        broken("a thing of two links", "<link name=\"link\">\n        <inertial><mass>0.06",
               "<link name=\"other\"/><link name=\"link\">\n        <inertial><mass>0.06", "one link");
        broken("a thing that touches nothing", "<link name=\"link\">\n        <inertial><mass>0.06</mass>",
               "<link name=\"link\"><inertial><mass>1</mass></inertial></link></model><model name=\"more\">"
               "<link name=\"link\">\n        <inertial><mass>0.06</mass>",
               "\"ball\" has no collision");
        broken("a thing that bounces higher than it fell", "<restitution_coefficient>0.6",
               "<restitution_coefficient>1.6", "");
        broken("a thing of two surfaces", "<friction>0.9</friction>", "<friction>0.1</friction>", "one surface");
        broken("a house in a house", "<link name=\"link\">",
               "<model name=\"m\"><link name=\"l\"/></model><link name=\"link\">", "models in it");
    }

    void replace(const std::string& from, const std::string& to) {
        std::string text = readAll(sdf());
        const std::size_t at = text.find(from);
        QVERIFY2(at != std::string::npos, from.c_str());
        writeAll(sdf(), text.replace(at, from.size(), to));
    }

    std::filesystem::path folder() const { return pathOf(*folder_); }
    std::filesystem::path sdf() const { return folder() / "world.sdf"; }

    std::unique_ptr<QTemporaryDir> folder_;
    World world_;
};

USAR_TEST(tst_WorldReader)

} // namespace tst_world_reader

#include "tst_world_reader.moc"
