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

using usar::Pose;
using usar::doubles::pathOf;
using usar::doubles::readAll;
using usar::doubles::writeAll;
using usar::sim::BoxShape;
using usar::sim::CapsuleShape;
using usar::sim::CylinderShape;
using usar::sim::SphereShape;
using usar::sim::VictimPartKind;
using usar::sim::World;
using usar::sim::WorldObject;

class tst_WorldReader : public QObject {
    Q_OBJECT

private slots:
    void init();
    void readsBackWhatWasWritten();
    void northIsTheTopOfThePicture();
    void posesOfModelLinkAndCollisionAddUp();
    void massesNeedNotSitInTheMiddleOfALink();
    void whatIsNotSaidOfASurfaceIsUsual();
    void aWorldWithoutPlantsOrWaterIsFine();
    void refusesAndSaysWhere_data();
    void refusesAndSaysWhere();
    void refusesAWrongPicture();
    void refusesABadPlantWithItsLine();
    void refusesMissingFolders_data();
    void refusesMissingFolders();
    void refusesEveryCutFile();
    void namesTheLineOfBadSdf_data();
    void namesTheLineOfBadSdf();
    void refusesAnotherKindOfXml();
    void aFloorNeedsNoPicture_data();
    void aFloorNeedsNoPicture();
    void boxesAloneAreAWorld();
    void steepLandIsKeptInWiderSteps_data();
    void steepLandIsKeptInWiderSteps();
    void writesNothingWithoutGround();
    void writesNothingWithHeightsThatAreNoNumbers();

private:
    static void addBrokenTags(); ///< and victims
    static void addBrokenSources();
    static void addBrokenThings();
    void replace(const std::string& from, const std::string& to);
    std::filesystem::path folder() const { return pathOf(*folder_); }
    std::filesystem::path sdf() const { return folder() / "world.sdf"; }

    std::unique_ptr<QTemporaryDir> folder_;
    World world_;
};

namespace {

WorldObject ball() {
    WorldObject ball{.name = "ball", .class_name = "USARModels.SoccerBall", .body = {}, .body_in_map = {}};
    ball.body = {.mass_kg = 0.06,
                 .inertia_kg_m2 = usar::Vec3::Constant(7.4e-5),
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
    World world = usar::doubles::woodedWorld(9, 12, 32.0);
    world.name = "small & <odd>";
    world.terrain = usar::doubles::terrainOf(17, 2.0, [](double x, double y) { return x / 8.0 + y * y / 64.0 - 3.0; });
    world.boxes = {{{.position_m = {4.0, -5.0, 1.5}, .yaw_rad = 0.4}, {3.0, 5.0, 3.0}}};
    world.objects = {ball(), barrow()};
    world.rfid_tags = {{7, "exit <left> & \"up\"", {1.0, 2.0, 0.25}}, {0, "", {-1.0, 0.1, 0.0}}};
    world.victims = {
        {"Becky", "Calm", {{VictimPartKind::Head, {3.0, 1.0, 0.5}}, {VictimPartKind::Foot, {4.5, 1.0, 0.1}}}},
        {"Sam", "", {{VictimPartKind::Hand, {-3.0, 1.5, 0.5}}}}};
    world.sounds = {{"alarm", 82.5, {0.0, -4.0, 2.0}}};
    world.gases = {{"CO2", 0.04, {3.0, 1.0, 0.6}}};
    world.gps_reference = {-36.8764, 174.7647};
    world.water = usar::sim::Water{.surface_z_m = -2.5, .density_kg_m3 = 1025.0};
    world.start_poses = {{"PlayerStart", {.position_m = {1.0, 2.0, 0.5}, .yaw_rad = 1.25}},
                         {"Second \"place\"", {.position_m = {-3.0, 0.0, 0.0}, .roll_rad = 0.1, .pitch_rad = -0.2}}};
    return world;
}

} // namespace

void tst_WorldReader::init() {
    folder_ = std::make_unique<QTemporaryDir>();
    world_ = smallWorld();
    QVERIFY(usar::sim::writeWorld(world_, folder()));
}

void tst_WorldReader::replace(const std::string& from, const std::string& to) {
    std::string text = readAll(sdf());
    const std::size_t at = text.find(from);
    QVERIFY2(at != std::string::npos, from.c_str());
    writeAll(sdf(), text.replace(at, from.size(), to));
}

void tst_WorldReader::readsBackWhatWasWritten() {
    const auto read = usar::sim::readWorld(folder());
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

void tst_WorldReader::northIsTheTopOfThePicture() {
    const auto image = usar::sim::readHeightPng(folder() / "height.png");
    QVERIFY(image);
    // Lowest y and highest x of the ground: lower right corner of the picture.
    const double corner_m = -5.0 + image->values[16 * 17 + 16] / 1024.0;
    QVERIFY(std::abs(world_.terrain.height_m({16.0, -16.0}) - corner_m) < 1e-9);
}

void tst_WorldReader::posesOfModelLinkAndCollisionAddUp() {
    replace(
        "<model name=\"buildings\">\n      <static>true</static>\n      <link name=\"link\">",
        "<model name=\"buildings\">\n      <static>true</static>\n      <pose>3 -3 1 0 0 1.5707963267948966</pose>\n"
        "      <link name=\"link\"><pose>1 0 0 0 0 0</pose>");
    replace("<pose>4 -5 1.5 0 0 0.4</pose>", "<pose>0 1 0.5 0 0 0</pose>");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->boxes[0].center_in_map.position_m.isApprox(usar::Vec3{2.0, -2.0, 1.5}, 1e-9));
}

void tst_WorldReader::massesNeedNotSitInTheMiddleOfALink() {
    replace("<pose>2 0.5 0.043 0 0 0</pose>", "<pose>2 0.5 1 0 0 1.5707963267948966</pose>");
    replace("<inertial><mass>0.06", "<inertial><pose>0.1 0 0 0 0 0</pose><mass>0.06");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->objects[0].body_in_map.position_m.isApprox(usar::Vec3{2.0, 0.6, 1.0}, 1e-9));
    QVERIFY(read->objects[0].body.parts[0].part_in_body.position_m.isApprox(usar::Vec3{-0.1, 0.0, 0.0}, 1e-9));
}

void tst_WorldReader::whatIsNotSaidOfASurfaceIsUsual() {
    replace("<bounce><restitution_coefficient>0.6</restitution_coefficient></bounce>", "");
    replace("<friction>0.5</friction><rolling_friction>0.001</rolling_friction>", "");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->objects[0].body.friction, usar::sim::BodyDescription{}.friction);
    QCOMPARE(read->objects[0].body.restitution, 0.0);
    QCOMPARE(read->objects[0].body.rolling_friction_m, 0.0);
}

void tst_WorldReader::aWorldWithoutPlantsOrWaterIsFine() {
    world_.plants.clear();
    world_.water.reset();
    QVERIFY(usar::sim::writeWorld(world_, folder()));
    const auto read = usar::sim::readWorld(folder());
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->plants.empty() && !read->water);
}

void tst_WorldReader::refusesAndSaysWhere_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("word");
    QTest::newRow("posts not square") << QString("<size>32 32") << QString("<size>32 33")
                                      << QString("size of the height map");
    QTest::newRow("size zero") << QString("<size>32 32") << QString("<size>0 0") << QString("size of the height map");
    QTest::newRow("size missing") << QString("<size>32 32") << QString("<size>") << QString("");
    QTest::newRow("no picture of that name") << QString("height.png") << QString("other.png") << QString("height map");
    QTest::newRow("no table of that name") << QString("plants.csv") << QString("other.csv") << QString("plants");
    QTest::newRow("scatter without a file")
        << QString("<usar:uri>plants.csv</usar:uri>") << QString("") << QString("usar:scatter");
    QTest::newRow("start pose with five numbers")
        << QString("1 2 0.5 0 0 1.25") << QString("1 2 0.5 0 0") << QString("usar:start_pose");
    QTest::newRow("start pose with seven numbers")
        << QString("1 2 0.5 0 0 1.25") << QString("1 2 0.5 0 0 1 1") << QString("usar:start_pose");
    QTest::newRow("start pose with a word")
        << QString("1 2 0.5 0 0 1.25") << QString("1 2 0.5 0 0 east") << QString("usar:start_pose");
    QTest::newRow("start pose without a name")
        << QString(" name=\"PlayerStart\"") << QString("") << QString("usar:start_pose");
    QTest::newRow("water without a surface")
        << QString("<usar:surface_z>-2.5</usar:surface_z>") << QString("") << QString("usar:water");
    QTest::newRow("water without weight") << QString("1025") << QString("0") << QString("usar:water");
    QTest::newRow("a box with words for sizes")
        << QString("<size>3 5 3</size>") << QString("<size>big</size>") << QString("");
    QTest::newRow("a shape that we cannot cast at")
        << QString("<box><size>3 5 3</size></box>") << QString("<sphere><radius>1</radius></sphere>")
        << QString("neither a box");
    QTest::newRow("two height maps") << QString("<box><size>3 5 3</size></box>")
                                     << QString("<heightmap><uri>height.png</uri><size>32 32 1</size></heightmap>")
                                     << QString("two grounds");
    QTest::newRow("a height map and a floor") << QString("<box><size>3 5 3</size></box>")
                                              << QString("<plane><size>10 10</size></plane>") << QString("two grounds");
    QTest::newRow("an element that nobody knows")
        << QString("</world>") << QString("<usar:treasure>1 2 3</usar:treasure></world>") << QString("usar:treasure");
    QTest::newRow("two start poses of one name")
        << QString("</world>") << QString("<usar:start_pose name=\"PlayerStart\">0 0 0 0 0 0</usar:start_pose></world>")
        << QString("two start poses");
    QTest::newRow("no start pose") << QString("usar:start_pose name=\"PlayerStart\"")
                                   << QString("usar:start_pose name=\"\"") << QString("usar:start_pose");
    QTest::newRow("two waters") << QString("</world>")
                                << QString("<usar:water><usar:surface_z>1</usar:surface_z><usar:density>1000"
                                           "</usar:density></usar:water></world>")
                                << QString("second usar:water");
    QTest::newRow("a box without size") << QString("<size>3 5 3</size>") << QString("<size>3 0 3</size>")
                                        << QString("box without size");
    addBrokenTags();
    addBrokenSources();
    addBrokenThings();
}

void tst_WorldReader::addBrokenTags() {
    QTest::newRow("a tag without a number") << QString("id=\"7\"") << QString("") << QString("usar:rfid_tag");
    QTest::newRow("a tag with a word for a number")
        << QString("id=\"7\"") << QString("id=\"seven\"") << QString("usar:rfid_tag");
    QTest::newRow("a tag with a number below zero")
        << QString("id=\"7\"") << QString("id=\"-7\"") << QString("usar:rfid_tag");
    QTest::newRow("a tag with a number beyond an int")
        << QString("id=\"7\"") << QString("id=\"7000000000\"") << QString("usar:rfid_tag");
    QTest::newRow("a tag in two dimensions") << QString(">1 2 0.25<") << QString(">1 2<") << QString("usar:rfid_tag");
    QTest::newRow("two tags with one number")
        << QString("id=\"7\"") << QString("id=\"0\"") << QString("two tags with the id 0");
    QTest::newRow("a victim without a name")
        << QString("usar:victim name=\"Becky\"") << QString("usar:victim") << QString("usar:victim needs a name");
    QTest::newRow("a victim with a wing") << QString("kind=\"Hand\"") << QString("kind=\"Wing\"") << QString("Pelvis");
    QTest::newRow("a victim with a part nowhere") << QString(">4.5 1 0.1<") << QString("><") << QString("usar:part");
    QTest::newRow("a victim with something else in it")
        << QString("<usar:part kind=\"Foot\">4.5 1 0.1</usar:part>") << QString("<usar:leg/>") << QString("usar:part");
    QTest::newRow("a victim without parts") << QString("<usar:part kind=\"Hand\">-3 1.5 0.5</usar:part>") << QString("")
                                            << QString("\"Sam\" has no usar:part");
}

void tst_WorldReader::addBrokenSources() {
    QTest::newRow("a sound without loudness") << QString(" loudness=\"82.5\"") << QString("") << QString("usar:sound");
    QTest::newRow("an endless sound") << QString("82.5") << QString("inf") << QString("usar:sound");
    QTest::newRow("a sound without a name") << QString(" name=\"alarm\"") << QString("") << QString("usar:sound");
    QTest::newRow("a sound nowhere") << QString("0 -4 2<") << QString("here<") << QString("usar:sound");
    QTest::newRow("a gas without a name") << QString(" gas=\"CO2\"") << QString("") << QString("usar:gas");
    QTest::newRow("less than no gas") << QString("density=\"0.04") << QString("density=\"-0.04") << QString("usar:gas");
    QTest::newRow("a gas nowhere") << QString("3 1 0.6<") << QString("3 1 0.6 9<") << QString("usar:gas");
    QTest::newRow("a place beyond the pole")
        << QString("-36.8764") << QString("-96.8764") << QString("usar:gps_reference");
    QTest::newRow("a place without a longitude")
        << QString(" longitude=\"174.7647\"") << QString("") << QString("usar:gps_reference");
}

void tst_WorldReader::addBrokenThings() {
    QTest::newRow("a thing without mass")
        << QString("<inertial><mass>0.06</mass>") << QString("<inertial><mass>0</mass>") << QString("ball");
    QTest::newRow("a thing without inertia")
        << QString("<ixx>7.4e-05</ixx>") << QString("<ixx>0</ixx>") << QString("ball");
    QTest::newRow("a thing of unknown mass")
        << QString(
               "<inertial><mass>0.06</mass><inertia><ixx>7.4e-05</ixx><iyy>7.4e-05</iyy><izz>7.4e-05</izz></inertia>"
               "</inertial>")
        << QString("") << QString("\"ball\" needs an inertial");
    QTest::newRow("a thing whose inertia is askew")
        << QString("<ixx>7.4e-05</ixx>") << QString("<ixx>7.4e-05</ixx><ixy>1e-05</ixy>") << QString("main axes");
    QTest::newRow("a thing of an unknown shape")
        << QString("<sphere><radius>0.043</radius></sphere>") << QString("<plane><size>1 1</size></plane>")
        << QString("\"ball\" has a shape");
    QTest::newRow("a thing inside out") << QString("<radius>0.043") << QString("<radius>-0.043")
                                        << QString("\"ball\" has a shape without size");
    QTest::newRow("a thing of two links")
        << QString("<link name=\"link\">\n        <inertial><mass>0.06")
        << QString("<link name=\"other\"/><link name=\"link\">\n        <inertial><mass>0.06") << QString("one link");
    QTest::newRow("a thing that touches nothing")
        << QString("<link name=\"link\">\n        <inertial><mass>0.06</mass>")
        << QString("<link name=\"link\"><inertial><mass>1</mass></inertial></link></model><model name=\"more\">"
                   "<link name=\"link\">\n        <inertial><mass>0.06</mass>")
        << QString("\"ball\" has no collision");
    QTest::newRow("a thing that bounces higher than it fell")
        << QString("<restitution_coefficient>0.6") << QString("<restitution_coefficient>1.6") << QString("");
    QTest::newRow("a thing of two surfaces")
        << QString("<friction>0.9</friction>") << QString("<friction>0.1</friction>") << QString("one surface");
    QTest::newRow("a house in a house") << QString("<link name=\"link\">")
                                        << QString("<model name=\"m\"><link name=\"l\"/></model><link name=\"link\">")
                                        << QString("models in it");
}

void tst_WorldReader::refusesAndSaysWhere() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, word);
    replace(from.toStdString(), to.toStdString());
    const auto read = usar::sim::readWorld(folder());
    QVERIFY(!read);
    QVERIFY2(read.error().what.find(word.toStdString()) != std::string::npos, read.error().text().c_str());
    QVERIFY(read.error().where.starts_with(folder().string()));
    QVERIFY(!read.error().mend.empty());
}

void tst_WorldReader::refusesAWrongPicture() {
    writeAll(folder() / "height.png", "GIF89a");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY(!read);
    QCOMPARE(read.error().where, (folder() / "height.png").string());
}

void tst_WorldReader::refusesABadPlantWithItsLine() {
    writeAll(folder() / "plants.csv", readAll(folder() / "plants.csv") + "round,1,2\n");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY(!read);
    QCOMPARE(read.error().where, (folder() / "plants.csv").string() + ":14");
}

void tst_WorldReader::refusesMissingFolders_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("no folder") << QString("nowhere");
    QTest::newRow("a folder without a world") << QString("empty");
    QTest::newRow("a file") << QString("height.png");
}

void tst_WorldReader::refusesMissingFolders() {
    QFETCH(QString, name);
    std::filesystem::create_directory(folder() / "empty");
    const auto read = usar::sim::readWorld(folder() / name.toStdString());
    QVERIFY(!read);
    QCOMPARE(read.error().where, (folder() / name.toStdString()).string());
    QVERIFY(!read.error().mend.empty());
}

void tst_WorldReader::refusesEveryCutFile() {
    const std::string text = readAll(sdf());
    for (const std::size_t part : {0u, 1u, 2u, 3u}) {
        writeAll(sdf(), text.substr(0, text.size() * part / 4));
        const auto read = usar::sim::readWorld(folder());
        QVERIFY(!read);
        QVERIFY(read.error().where.starts_with(sdf().string()));
        QVERIFY(!read.error().what.empty() && !read.error().mend.empty());
    }
}

void tst_WorldReader::namesTheLineOfBadSdf_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::newRow("a tag that is not closed") << QString("<static>true</static>") << QString("<static>true</model>");
    QTest::newRow("a model without a name") << QString("<model name=\"ground\">\n      <static>true</static>")
                                            << QString("<model>\n      <static>true</static>");
    QTest::newRow("a shape that we cannot cast at")
        << QString("<box><size>3 5 3</size></box>") << QString("<sphere><radius>1</radius></sphere>");
    QTest::newRow("posts not square") << QString("<size>32 32") << QString("<size>32 33");
    QTest::newRow("a tag in two dimensions") << QString(">1 2 0.25<") << QString(">1 2<");
    QTest::newRow("the second tag, after a comment of two lines")
        << QString("<usar:rfid_tag id=\"0\"") << QString("<!-- <usar:rfid_tag\n--><usar:rfid_tag id=\"no\"");
    QTest::newRow("a victim with a wing") << QString("kind=\"Hand\"") << QString("kind=\"Wing\"");
    QTest::newRow("a water without weight") << QString("1025") << QString("0");
}

void tst_WorldReader::namesTheLineOfBadSdf() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    const std::string before = readAll(sdf());
    const auto at = static_cast<std::ptrdiff_t>(before.find(from.toStdString()));
    const auto broken_line = 1 + std::count(before.begin(), before.begin() + at, '\n');
    replace(from.toStdString(), to.toStdString());
    const auto read = usar::sim::readWorld(folder());
    QVERIFY(!read);
    const std::string file_and_colon = sdf().string() + ":";
    QVERIFY2(read.error().where.starts_with(file_and_colon), read.error().text().c_str());
    const int line = std::stoi(read.error().where.substr(file_and_colon.size()));
    QVERIFY2(std::abs(line - broken_line) <= 1, read.error().text().c_str());
}

void tst_WorldReader::refusesAnotherKindOfXml() {
    writeAll(sdf(), "<html></html>");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY(!read);
    QCOMPARE(read.error().what, std::string("this is not SDFormat"));
}

void tst_WorldReader::aFloorNeedsNoPicture_data() {
    QTest::addColumn<double>("width_m");
    QTest::addColumn<double>("depth_m");
    QTest::addColumn<double>("z_m");
    QTest::newRow("a square at zero") << 10.0 << 10.0 << 0.0;
    QTest::newRow("a hall") << 41.0 << 26.0 << 0.0;
    QTest::newRow("a cellar") << 6.5 << 4.25 << -3.5;
    QTest::newRow("a corridor upstairs") << 2.0 << 64.0 << 3.1;
}

void tst_WorldReader::aFloorNeedsNoPicture() {
    QFETCH(double, width_m);
    QFETCH(double, depth_m);
    QFETCH(double, z_m);
    const usar::Vec2 half_m = usar::Vec2(width_m, depth_m) / 2.0;
    const auto floor = usar::sim::Terrain::level({-half_m, half_m}, z_m);
    QVERIFY(floor);
    world_.terrain = *floor;
    const QTemporaryDir other;
    QVERIFY(usar::sim::writeWorld(world_, pathOf(other)));
    QVERIFY(!std::filesystem::exists(pathOf(other) / "height.png"));
    const auto read = usar::sim::readWorld(pathOf(other));
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->terrain == world_.terrain);
    QCOMPARE(usar::sim::extentOf(*read), (usar::Rectangle{-half_m, half_m}));
    QVERIFY(std::abs(read->terrain.height_m({0.3, 0.7}) - z_m) < 1e-6);
}

void tst_WorldReader::boxesAloneAreAWorld() {
    world_.terrain = {};
    world_.plants.clear();
    const QTemporaryDir other;
    QVERIFY(usar::sim::writeWorld(world_, pathOf(other)));
    const auto read = usar::sim::readWorld(pathOf(other));
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->terrain.empty());
    // A box of 3 x 5 turned by 0.4 around (4, -5).
    const usar::Vec2 reach_m(1.5 * std::cos(0.4) + 2.5 * std::sin(0.4), 1.5 * std::sin(0.4) + 2.5 * std::cos(0.4));
    QVERIFY(usar::sim::extentOf(*read).max_m.isApprox(usar::Vec2(4.0, -5.0) + reach_m, 1e-9));
    QVERIFY(usar::sim::extentOf(*read).min_m.isApprox(usar::Vec2(4.0, -5.0) - reach_m, 1e-9));
}

void tst_WorldReader::steepLandIsKeptInWiderSteps_data() {
    QTest::addColumn<double>("slope");
    QTest::addColumn<double>("step_m");
    QTest::newRow("60 m fit 1/1024 m") << 60.0 / 8.0 << 1.0 / 1024.0;
    QTest::newRow("100 m need 1/512 m") << 100.0 / 8.0 << 1.0 / 512.0;
    QTest::newRow("200 m need 1/256 m") << 200.0 / 8.0 << 1.0 / 256.0;
    QTest::newRow("9 km need 1/4 m") << 9000.0 / 8.0 << 1.0 / 4.0;
}

void tst_WorldReader::steepLandIsKeptInWiderSteps() {
    QFETCH(double, slope);
    QFETCH(double, step_m);
    world_.terrain = usar::doubles::terrainOf(
        9, 1.0, [&](double x, double y) { return std::round((slope * x + 0.37 * y) / step_m) * step_m; });
    QVERIFY(usar::sim::writeWorld(world_, folder()));
    const auto read = usar::sim::readWorld(folder());
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->terrain == world_.terrain);
}

void tst_WorldReader::writesNothingWithoutGround() {
    world_.terrain = {};
    world_.boxes.clear();
    const QTemporaryDir other;
    QVERIFY(!usar::sim::writeWorld(world_, pathOf(other) / "void"));
    QVERIFY(!std::filesystem::exists(pathOf(other) / "void"));
}

void tst_WorldReader::writesNothingWithHeightsThatAreNoNumbers() {
    world_.terrain = usar::doubles::terrainOf(9, 1.0, [](double x, double) { return x == 0.0 ? std::nan("") : 1.0; });
    const QTemporaryDir other;
    QVERIFY(!usar::sim::writeWorld(world_, pathOf(other) / "void"));
    QVERIFY(!std::filesystem::exists(pathOf(other) / "void"));
}

USAR_TEST(tst_WorldReader)

} // namespace tst_world_reader

#include "tst_world_reader.moc"
