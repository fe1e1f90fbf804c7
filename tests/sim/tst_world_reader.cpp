#include "core/sim/world_reader.h"

#include <QtTest>

#include "core/sim/height_png.h"
#include "core/sim/world_writer.h"
#include "tests/doubles/test_files.h"
#include "tests/doubles/test_worlds.h"

using usar::doubles::pathOf;
using usar::doubles::readAll;
using usar::doubles::writeAll;
using usar::sim::World;

class TestWorldReader : public QObject {
    Q_OBJECT

private slots:
    void init();
    void readsBackWhatWasWritten();
    void northIsTheTopOfThePicture();
    void posesOfModelLinkAndCollisionAddUp();
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
    void writesNothingWithTooMuchRelief();

private:
    void replace(const std::string& from, const std::string& to);
    std::filesystem::path folder() const { return pathOf(*folder_); }
    std::filesystem::path sdf() const { return folder() / "world.sdf"; }

    std::unique_ptr<QTemporaryDir> folder_;
    World world_;
};

namespace {

/// 17 x 17 posts with heights in steps that files keep.
World smallWorld() {
    World world = usar::doubles::woodedWorld(9, 12, 32.0);
    world.name = "small & <odd>";
    world.terrain = usar::doubles::terrainOf(17, 2.0, [](double x, double y) { return x / 8.0 + y * y / 64.0 - 3.0; });
    world.boxes = {{{.position_m = {4.0, -5.0, 1.5}, .yaw_rad = 0.4}, {3.0, 5.0, 3.0}}};
    world.water = usar::sim::Water{.surface_z_m = -2.5, .density_kg_m3 = 1025.0};
    world.start_poses = {{"PlayerStart", {.position_m = {1.0, 2.0, 0.5}, .yaw_rad = 1.25}},
                         {"Second \"place\"", {.position_m = {-3.0, 0.0, 0.0}, .roll_rad = 0.1, .pitch_rad = -0.2}}};
    return world;
}

} // namespace

void TestWorldReader::init() {
    folder_ = std::make_unique<QTemporaryDir>();
    world_ = smallWorld();
    QVERIFY(usar::sim::writeWorld(world_, folder()));
}

void TestWorldReader::replace(const std::string& from, const std::string& to) {
    std::string text = readAll(sdf());
    const std::size_t at = text.find(from);
    QVERIFY2(at != std::string::npos, from.c_str());
    writeAll(sdf(), text.replace(at, from.size(), to));
}

void TestWorldReader::readsBackWhatWasWritten() {
    const auto read = usar::sim::readWorld(folder());
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->name, world_.name);
    QVERIFY(read->terrain.heights_m() == world_.terrain.heights_m());
    QCOMPARE(read->terrain.extent(), world_.terrain.extent());
    QVERIFY(read->plants == world_.plants);
    QVERIFY(read->water == world_.water);
    QVERIFY(read->start_poses == world_.start_poses);
    QCOMPARE(read->boxes.size(), std::size_t{1});
    QVERIFY(read->boxes[0].size_m == world_.boxes[0].size_m);
    QVERIFY(read->boxes[0].center_in_map.isometry().isApprox(world_.boxes[0].center_in_map.isometry(), 1e-12));
}

void TestWorldReader::northIsTheTopOfThePicture() {
    const auto image = usar::sim::readHeightPng(folder() / "height.png");
    QVERIFY(image);
    // Lowest y and highest x of the ground: lower right corner of the picture.
    const double corner_m = -5.0 + image->values[16 * 17 + 16] / 1024.0;
    QVERIFY(std::abs(world_.terrain.height_m({16.0, -16.0}) - corner_m) < 1e-9);
}

void TestWorldReader::posesOfModelLinkAndCollisionAddUp() {
    replace("<pose>4 -5 1.5 0 0 0.4</pose>\n      <link name=\"link\">",
            "<pose>4 -5 1.5 0 0 1.5707963267948966</pose>\n      <link name=\"link\"><pose>1 0 0 0 0 0</pose>");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->boxes[0].center_in_map.position_m.isApprox(usar::Vec3{4.0, -4.0, 1.5}, 1e-9));
}

void TestWorldReader::aWorldWithoutPlantsOrWaterIsFine() {
    world_.plants.clear();
    world_.water.reset();
    QVERIFY(usar::sim::writeWorld(world_, folder()));
    replace("<usar:scatter><usar:uri>plants.csv</usar:uri></usar:scatter>", "");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->plants.empty() && !read->water);
}

void TestWorldReader::refusesAndSaysWhere_data() {
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
    QTest::newRow("two grounds") << QString("<box><size>3 5 3</size></box>")
                                 << QString("<heightmap><uri>height.png</uri><size>32 32 1</size></heightmap>")
                                 << QString("two height maps");
}

void TestWorldReader::refusesAndSaysWhere() {
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

void TestWorldReader::refusesAWrongPicture() {
    writeAll(folder() / "height.png", "GIF89a");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY(!read);
    QCOMPARE(read.error().where, (folder() / "height.png").string());
}

void TestWorldReader::refusesABadPlantWithItsLine() {
    writeAll(folder() / "plants.csv", readAll(folder() / "plants.csv") + "round,1,2\n");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY(!read);
    QCOMPARE(read.error().where, (folder() / "plants.csv").string() + ":14");
}

void TestWorldReader::refusesMissingFolders_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("no folder") << QString("nowhere");
    QTest::newRow("a folder without a world") << QString("empty");
    QTest::newRow("a file") << QString("height.png");
}

void TestWorldReader::refusesMissingFolders() {
    QFETCH(QString, name);
    std::filesystem::create_directory(folder() / "empty");
    const auto read = usar::sim::readWorld(folder() / name.toStdString());
    QVERIFY(!read);
    QCOMPARE(read.error().where, (folder() / name.toStdString()).string());
    QVERIFY(!read.error().mend.empty());
}

void TestWorldReader::refusesEveryCutFile() {
    const std::string text = readAll(sdf());
    for (const std::size_t part : {0u, 1u, 2u, 3u}) {
        writeAll(sdf(), text.substr(0, text.size() * part / 4));
        const auto read = usar::sim::readWorld(folder());
        QVERIFY(!read);
        QVERIFY(read.error().where.starts_with(sdf().string()));
        QVERIFY(!read.error().what.empty() && !read.error().mend.empty());
    }
}

void TestWorldReader::namesTheLineOfBadSdf_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::newRow("a tag that is not closed") << QString("<static>true</static>") << QString("<static>true</model>");
    QTest::newRow("a model without a name") << QString("<model name=\"ground\">\n      <static>true</static>")
                                            << QString("<model>\n      <static>true</static>");
}

void TestWorldReader::namesTheLineOfBadSdf() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    replace(from.toStdString(), to.toStdString());
    const auto read = usar::sim::readWorld(folder());
    QVERIFY(!read);
    const std::string file_and_colon = sdf().string() + ":";
    QVERIFY2(read.error().where.starts_with(file_and_colon), read.error().text().c_str());
    const int line = std::stoi(read.error().where.substr(file_and_colon.size()));
    QVERIFY2(line == 4 || line == 5, read.error().text().c_str());
}

void TestWorldReader::refusesAnotherKindOfXml() {
    writeAll(sdf(), "<html></html>");
    const auto read = usar::sim::readWorld(folder());
    QVERIFY(!read);
    QCOMPARE(read.error().what, std::string("this is not SDFormat"));
}

void TestWorldReader::writesNothingWithTooMuchRelief() {
    world_.terrain = usar::doubles::terrainOf(9, 1.0, [](double x, double) { return 10.0 * x; });
    const QTemporaryDir other;
    QVERIFY(!usar::sim::writeWorld(world_, pathOf(other) / "steep"));
    QVERIFY(!std::filesystem::exists(pathOf(other) / "steep" / "world.sdf"));
}

QTEST_APPLESS_MAIN(TestWorldReader)
#include "tst_world_reader.moc"
