// Worlds and robots of a person's own in the real window: what is fine is taken, what is broken costs one message.
#include <QDir>
#include <QFile>
#include <QTest>

#include "core/sim/world/world_writer.h"
#include "tests/doubles/test_files.h"
#include "tests/doubles/test_worlds.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_files {

using namespace usar;
using doubles::pathOf;
using doubles::readAll;
using doubles::writeAll;

namespace {

/// A mended or broken copy of a robot that comes with the program.
void writeRobot(const QString& file, const std::string& from, const std::string& to) {
    std::string text = readAll(USAR_SOURCE_DIR "/resources/robots/P2DX.sdf");
    const std::size_t at = text.find(from);
    QVERIFY2(at != std::string::npos, from.c_str());
    writeAll(file.toStdString(), text.replace(at, from.size(), to));
}

int messagesOf(WindowPage& page, const QString& words) {
    const auto* const model = page.window().views().notifications->model();
    int count = 0;
    for (int row = 0; row < model->rowCount(); ++row)
        count += model->row(row).text.contains(words) ? model->row(row).count : 0;
    return count;
}

/// A running robot and what is shown of its world.
struct BusyPage : WindowPage {
    bool spawned = hasPoses() && spawnAt("PlayerStart");
    QString level = window().control().level();

    bool hasPoses() {
        return QTest::qWaitFor([this] { return hasStartPoses(); }, soon_ms);
    }
    /// The same robot in the same world, and it lives.
    bool goesOn() {
        if (window().control().level() != level || window().control().robots().size() != 1)
            return false;
        const double now_s = robot(1)->figures.now.count();
        return QTest::qWaitFor([&] { return robot(1)->figures.now.count() > now_s + 0.5; }, soon_ms);
    }
};

} // namespace

class tst_WindowFiles : public QObject {
    Q_OBJECT
private slots:
    void init() {
        GuiWatchdog::instance().reset();
        folder_ = std::make_unique<QTemporaryDir>();
    }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }

    void aBrokenWorldIsRefusedAndNothingElseChanges_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("dropped");
        QTest::addColumn<QStringList>("words");
        QTest::newRow("no XML, as a folder") << "world.sdf"
                                             << "</world>"
                                             << "</wrold>"
                                             << "" << QStringList{"world.sdf:3", "the XML is broken"};
        QTest::newRow("a start pose without a name, as its file")
            << "world.sdf"
            << "usar:start_pose name="
            << "usar:start_pose nome="
            << "world.sdf" << QStringList{"world.sdf:12", "a usar:start_pose needs a name"};
        QTest::newRow("a tree that is none") << "plants.csv"
                                             << "round"
                                             << "spear"
                                             << "" << QStringList{"plants.csv:2", "the kind is \"spear\""};
    }

    void aBrokenWorldIsRefusedAndNothingElseChanges() {
        QFETCH(const QString, file);
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        QFETCH(const QString, dropped);
        QFETCH(const QStringList, words);
        const QString world = writeWorld();
        const std::filesystem::path path = (world + "/" + file).toStdString();
        QString text = QString::fromStdString(readAll(path));
        QVERIFY(text.contains(from));
        writeAll(path, text.replace(text.indexOf(from), from.size(), to).toStdString());
        BusyPage page;
        QVERIFY(page.spawned);
        QVERIFY(page.dropFile(dropped.isEmpty() ? world : world + "/" + dropped));
        for (const QString& word : words)
            QTRY_VERIFY2_WITH_TIMEOUT(page.notified(file).contains(word), qPrintable(page.notified(file)), soon_ms);
        QVERIFY(page.goesOn());
        QCOMPARE(messagesOf(page, file), 1);
        QVERIFY(!page.window().views().progress->isVisible());
        page.screenshot("world_folder_refused");
    }

    void aWorldThatIsDroppedIsOpened() {
        const QString world = writeWorld();
        BusyPage page;
        QVERIFY(page.spawned);
        QVERIFY(page.dropFile(world));
        QTRY_COMPARE_WITH_TIMEOUT(page.window().control().level(), QString("wood"), soon_ms);
        QVERIFY(page.window().control().robots().empty());
        QVERIFY(page.spawnAt("PlayerStart"));
    }

    void noWorldIsOpenedUnderARobotOnItsMission() {
        BusyPage page;
        QVERIFY(page.spawned);
        page.pressKey(Qt::Key_A);
        page.drawArea({{-20, -15}, {20, 15}});
        page.press("Start");
        QTRY_VERIFY_WITH_TIMEOUT(page.window().control().robot({1})->running(), soon_ms);
        QVERIFY(page.dropFile(writeWorld()));
        QVERIFY(!page.notified("A robot is on its mission").isEmpty());
        QVERIFY(page.goesOn());
        QVERIFY(page.window().control().robot({1})->running());
    }

    void aBrokenRobotIsRefusedAndNothingElseChanges() {
        const QString file = folder_->filePath("Broken.sdf");
        writeRobot(file, "<usar:joint>LeftWheel</usar:joint>", "<usar:joint>LeftWing</usar:joint>");
        BusyPage page;
        QVERIFY(page.spawned);
        QVERIFY(page.dropFile(file));
        QTRY_VERIFY2_WITH_TIMEOUT(page.notified("Broken.sdf").contains("LeftWing"),
                                  qPrintable(page.notified("Broken.sdf")), soon_ms);
        QVERIFY(page.goesOn());
        QCOMPARE(messagesOf(page, "Broken.sdf"), 1);
        page.screenshot("robot_file_refused");
    }

    void aRobotThatIsDroppedCanBeSpawnedHereAndInTheNextWorld() {
        const QString file = folder_->filePath("Mine.sdf");
        writeRobot(file, "<model name=\"P2DX\">", "<model name=\"MyOwn\">");
        BusyPage page;
        QVERIFY(page.spawned);
        QVERIFY(page.dropFile(file));
        QTRY_VERIFY_WITH_TIMEOUT(!page.notified("MyOwn can be spawned").isEmpty(), soon_ms);
        const auto spawnsMine = [&] {
            Pose start_in_map = page.map().content().start_poses.front().pose_in_map;
            start_in_map.position_m += Vec3(2.0, 0.0, 1.0);
            const auto id = page.window().control().spawn({"USARBot.MyOwn", "Own", start_in_map});
            return id && QTest::qWaitFor([&] { return page.robot(*id)->figures.spawned; }, soon_ms);
        };
        QVERIFY(spawnsMine());
        QVERIFY(page.dropFile(writeWorld()));
        QTRY_COMPARE_WITH_TIMEOUT(page.window().control().level(), QString("wood"), soon_ms);
        QTRY_VERIFY_WITH_TIMEOUT(page.window().control().checkLine(page.window().control().connectionOf({})), soon_ms);
        QVERIFY(spawnsMine());
    }

    void whatIsNoneOfOursIsNotTaken() {
        BusyPage page;
        QVERIFY(page.spawned);
        writeAll(pathOf(*folder_) / "notes.txt", "something");
        QVERIFY(!page.dropFile(folder_->filePath("notes.txt")));
        QVERIFY(!page.dropFile(folder_->path()));
    }

private:
    QString writeWorld() {
        const QString folder = folder_->filePath("wood");
        if (!sim::writeWorld(doubles::woodedWorld(5, 20), folder.toStdString()))
            QTest::qFail("the world cannot be written", __FILE__, __LINE__);
        return folder;
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

USAR_TEST(tst_WindowFiles)

} // namespace tst_window_files

#include "tst_window_files.moc"
