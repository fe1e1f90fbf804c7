// A real flight, recorded by the window, and watched again in it.
#include <cmath>

#include <QAbstractButton>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QGuiApplication>
#include <QInputDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QSettings>
#include <QSpinBox>
#include <QTest>

#include "core/campaign/plan/shell_words.h"
#include "core/server/embedded/window_options.h"
#include "tests/doubles/mcap_file.h"
#include "tests/doubles/test_files.h"
#include "tests/doubles/two_flights.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/scratch_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/models/figures.h"

namespace tst_window_replay {

using namespace usar;

namespace {

double lengthOf(const std::vector<Vec2>& points_m) {
    double length_m = 0.0;
    for (std::size_t i = 1; i < points_m.size(); ++i)
        if (const double step_m = (points_m[i] - points_m[i - 1]).norm(); std::isfinite(step_m))
            length_m += step_m;
    return length_m;
}

QString figureOf(const widgets::WindowViews& views, const QString& caption) {
    for (const widgets::Readout* readout : views.status->findChildren<widgets::Readout*>())
        if (readout->accessibleName() == caption)
            return readout->text().trimmed();
    return {};
}

QStringList recordingsIn(const QString& folder) {
    return QDir(folder).entryList({"*.usarrec"}, QDir::Files);
}

} // namespace

class tst_WindowReplay : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void theReplayShowsWhatTheFlightShowed();
    void theStatusIsThatOfTheMomentShown();
    void theStatusIsThatOfTheFlightShown_data();
    void theStatusIsThatOfTheFlightShown();
    void aRecordingIsDroppedOnTheWindow();
    void theCommandLineOpensARecordingWithoutAServer();
    void aLinkToAMomentLeadsThere();
    void theRobotOfTheCommandLineStaysSelected();
    void nothingCanBeSentAndTheLiveRobotGoesOn();
    void recordingIsTurnedOffAndOn();
    void recordingsGetALimitThatIsKeptForTheNextStart();
    void aFileThatIsNoRecordingIsRefusedWithAMend();
    void theRecordingIsExported();

private:
    /// Answers the dialog that asks where to export to.
    static bool exportsTo(WindowPage& page, const QString& file);
    bool opens(WindowPage& page);

    QTemporaryDir folder_;
    QString recording_;
    std::size_t tiles_ = 0;
    std::size_t marks_ = 0;
};

void tst_WindowReplay::initTestCase() {
    WindowPage page({.result_folder = folder_.path()});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.doubleClickStartPose("PlayerStart");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned, soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(page.window().views().record->text().contains("MB"), soon_ms);
    page.pressKey(Qt::Key_A);
    page.drawArea({{-15, -10}, {15, 10}});
    page.chooseSpeed("max");
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished.has_value(), flight_ms);
    tiles_ = page.knownTiles();
    marks_ = page.robot(1)->marks.size();
    QVERIFY(tiles_ > 0);
    page.window().control().remove({1});
    QTRY_VERIFY_WITH_TIMEOUT(!page.endedRecording().isEmpty(), soon_ms);
    recording_ = page.endedRecording();
    QCOMPARE(recordingsIn(folder_.path()).size(), 1);
    QVERIFY2(recording_.contains("/R1_"), qPrintable(recording_));
}

bool tst_WindowReplay::opens(WindowPage& page) {
    page.window().control().openRecording(recording_);
    return QTest::qWaitFor(
        [&] {
            const auto* view = page.robot(page.window().selectedRobot());
            return view && !view->recording.isEmpty() && view->figures.replay;
        },
        soon_ms);
}

void tst_WindowReplay::theReplayShowsWhatTheFlightShowed() {
    WindowPage page;
    QVERIFY(opens(page));
    const RobotId id = page.window().selectedRobot();
    QVERIFY(page.window().views().replay->isVisible());
    QVERIFY(page.window().views().hint->isHidden());
    QVERIFY(!page.robot(id)->figures.replay->playing);
    page.pressKey(Qt::Key_Space);
    for (int i = 0; i < 7; ++i)
        page.pressKey(Qt::Key_Up, Qt::AltModifier);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(id)->finished && !page.robot(id)->figures.replay->playing, flight_ms);
    QCOMPARE(page.knownTiles(), tiles_);
    QCOMPARE(page.robot(id)->marks.size(), marks_);
    QVERIFY(page.robot(id)->trail_m.size() > 10);
    QVERIFY(page.window().views().messages->model().rowCount() > 100);
    QVERIFY(!page.robot(id)->unsaved);
    page.screenshot("replay_done");
    // A trail that jumps between the newest pose and the older ones of each update would be several times as long.
    const auto& shown = page.map().content().robots.at(QString::fromStdString(page.robot(id)->spawn.robot_name));
    QVERIFY(lengthOf(shown.trail.points_m()) < 1.2 * lengthOf(page.robot(id)->trail_m));

    const double span_s = page.robot(id)->figures.replay->span.count();
    QSlider* slider = page.window().views().replay->slider();
    QTest::mouseClick(slider, Qt::LeftButton, {}, {1, slider->height() / 2});
    QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() == 0 && page.robot(id)->marks.empty(), soon_ms);
    QTest::mouseClick(slider, Qt::LeftButton, {}, {slider->width() - 2, slider->height() / 2});
    QTRY_COMPARE_WITH_TIMEOUT(page.knownTiles(), tiles_, soon_ms);
    QCOMPARE(page.robot(id)->marks.size(), marks_);
    page.pressKey(Qt::Key_Left, Qt::AltModifier);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(page.robot(id)->figures.replay->position.count() - (span_s - 10.0)) < 0.5,
                             soon_ms);
}

/// Defect D14 of the review: in flight the replay said how it would end, and after a seek all figures were dashes.
void tst_WindowReplay::theStatusIsThatOfTheMomentShown() {
    WindowPage page;
    QVERIFY(opens(page));
    const RobotId id = page.window().selectedRobot();
    mission::Robot& robot = *page.window().control().robot(id);
    const widgets::WindowViews& views = page.window().views();
    const Seconds span = robot.view().figures.replay->span;
    const auto seek = [&](double share) {
        robot.orderReplay({.seek = span * share});
        return QTest::qWaitFor(
            [&] { return std::abs((robot.view().figures.replay->position - span * share).count()) < 1.0; }, soon_ms);
    };
    QVERIFY(seek(1.0));
    QTRY_VERIFY_WITH_TIMEOUT(robot.view().finished.has_value(), soon_ms);
    const QString ending = QString::fromStdString(robot.view().finished->reason);
    QTRY_COMPARE(views.status->accessibleDescription(), ending);
    for (const double share : {0.5, 0.7, 0.3}) {
        QVERIFY(seek(share));
        QVERIFY(!robot.view().finished && robot.view().status);
        const QString state = QString::fromStdString(robot.view().status->state);
        QTRY_COMPARE(views.status->accessibleDescription(), state);
        QVERIFY(state != ending);
        QTRY_COMPARE(figureOf(views, "elapsed"), widgets::clockText(robot.view().status->elapsed));
        QCOMPARE(views.robots->model().row(0).state, "replay · " + state);
    }
}

/// Defect D14, too: what an earlier flight told came after the one shown had begun.
void tst_WindowReplay::theStatusIsThatOfTheFlightShown_data() {
    QTest::addColumn<double>("at_s");
    QTest::addColumn<QString>("state");
    QTest::addColumn<QString>("flown");
    QTest::addColumn<QString>("row");
    QTest::newRow("in the second flight") << 5.5 << "again"
                                          << "2"
                                          << "replay · again";
    QTest::newRow("before its first status") << 4.5 << ""
                                             << "–"
                                             << "";
    QTest::newRow("after the first flight") << 3.5 << "Landed on request."
                                            << "7"
                                            << "replay · ended early";
    QTest::newRow("in the first flight") << 2.5 << "out"
                                         << "7"
                                         << "replay · out";
}

void tst_WindowReplay::theStatusIsThatOfTheFlightShown() {
    QFETCH(double, at_s);
    QFETCH(QString, state);
    QFETCH(QString, flown);
    QFETCH(QString, row);
    const QTemporaryDir folder;
    WindowPage page;
    page.window().control().openRecording(
        fileIn(folder, "R1.usarrec", QByteArray::fromStdString(doubles::twoFlights())));
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(page.window().selectedRobot()), soon_ms);
    mission::Robot& robot = *page.window().control().robot(page.window().selectedRobot());
    const widgets::WindowViews& views = page.window().views();
    for (const double moment_s : {6.0, at_s}) { // Once to the end, and back.
        robot.orderReplay({.seek = Seconds(moment_s)});
        QTRY_VERIFY_WITH_TIMEOUT(robot.view().figures.replay && !robot.view().figures.replay->seeking &&
                                     std::abs(robot.view().figures.replay->position.count() - moment_s) < 0.01,
                                 soon_ms);
    }
    QTRY_COMPARE(figureOf(views, "flown"), flown);
    const QString said = views.status->accessibleDescription();
    QVERIFY2(state.isEmpty() ? said != "Landed on request." : said == state, qPrintable(said));
    const QString listed = views.robots->model().row(0).state;
    QVERIFY2(row.isEmpty() ? !listed.contains("ended") : listed == row, qPrintable(listed));
}

void tst_WindowReplay::aRecordingIsDroppedOnTheWindow() {
    WindowPage page;
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(recording_)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&page.window(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&page.window(), &drop);
    QTRY_VERIFY_WITH_TIMEOUT(page.window().views().replay->isVisible(), soon_ms);
}

void tst_WindowReplay::theCommandLineOpensARecordingWithoutAServer() {
    WindowPage page({.recording = recording_});
    QTRY_VERIFY_WITH_TIMEOUT(page.window().views().replay->isVisible(), soon_ms);
    QVERIFY2(page.connectionText().contains("Not connected"), qPrintable(page.connectionText()));
    page.pressKey(Qt::Key_Period);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.lines_received > 0, soon_ms);
}

void tst_WindowReplay::aLinkToAMomentLeadsThere() {
    const QTemporaryDir folder;
    const QString name = "R1's flight & more.usarrec"; // a shell would take it apart
    const QString file = fileIn(folder, name, QByteArray::fromStdString(doubles::twoFlights()));
    QString link;
    {
        WindowPage page({.recording = file, .at = Seconds{5.25}, .select = "R1"});
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.replay, soon_ms);
        QTRY_COMPARE_WITH_TIMEOUT(page.robot(1)->figures.replay->position.count(), 5.25, soon_ms);
        QTRY_COMPARE(figureOf(page.window().views(), "flown"), QString("2"));
        page.window().commands().action("replay.copy_link")->trigger();
        link = QGuiApplication::clipboard()->text();
        QVERIFY2(page.notified("On the clipboard").contains("--at 5.25"), qPrintable(link));
    }
    const auto words = campaign::shellWords(link);
    QVERIFY2(words, words ? "" : words.error().text().c_str());
    QCOMPARE(*words, (QStringList{"mission-control", file, "--at", "5.25", "--select", "R1"}));
    const auto options = server::readWindowOptions(*words);
    QVERIFY(options && options->recording == file && options->at == Seconds{5.25} && options->select == "R1");
    WindowPage live;
    QVERIFY(!live.window().commands().action("replay.copy_link")->isEnabled());
}

void tst_WindowReplay::theRobotOfTheCommandLineStaysSelected() {
    WindowPage page({.select = "R1"});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.doubleClickStartPose("HillTop");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(2) && page.robot(2)->figures.spawned, soon_ms);
    QCOMPARE(page.window().selectedRobot(), RobotId{1});
    page.pressKey(Qt::Key_2);
    QCOMPARE(page.window().selectedRobot(), RobotId{2});
    page.window().control().openRecording(recording_); // Another one was chosen, so the newest is selected again.
    QTRY_COMPARE_WITH_TIMEOUT(page.window().selectedRobot(), RobotId{3}, soon_ms);
}

void tst_WindowReplay::nothingCanBeSentAndTheLiveRobotGoesOn() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    QVERIFY(opens(page));
    const RobotId replay = page.window().selectedRobot();
    QCOMPARE(replay.value, 2);
    QVERIFY(!page.window().commands().action("mission.start")->isEnabled());
    page.window().control().robot(replay)->send(protocol::GetStartPoses{}, by::Operator{"box"});
    QTRY_VERIFY_WITH_TIMEOUT(page.notified("This is a replay").contains("Connect"), soon_ms);
    QVERIFY(page.robot(1)->figures.spawned);
    page.pressKey(Qt::Key_1);
    QTRY_VERIFY(!page.window().views().replay->isVisible());
    page.pressKey(Qt::Key_2);
    QTRY_VERIFY(page.window().views().replay->isVisible());
    page.window().commands().action("replay.close")->trigger();
    QTRY_VERIFY(!page.robot(2));
    QVERIFY(page.robot(1)->figures.spawned);
}

void tst_WindowReplay::recordingIsTurnedOffAndOn() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().commands().action("file.record")->trigger();
    QVERIFY(page.spawnAt("PlayerStart"));
    QCOMPARE(page.window().views().record->text(), QString("not recorded"));
    QVERIFY(recordingsIn(page.resultFolder()).isEmpty());
    page.window().commands().action("file.record")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(page.window().views().record->text().contains("MB"), soon_ms);
    QCOMPARE(recordingsIn(page.resultFolder()).size(), 1);
    page.screenshot("recording");
    page.window().commands().action("file.record")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(page.window().views().record->text(), QString("not recorded"), soon_ms);
}

void tst_WindowReplay::recordingsGetALimitThatIsKeptForTheNextStart() {
    const QTemporaryDir settings;
    {
        WindowPage page({.settings_folder = settings.path()});
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QVERIFY(page.spawnAt("PlayerStart"));
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.recording, soon_ms);
        QVERIFY(!page.robot(1)->figures.recording->limit_bytes);
        page.window().commands().action("file.record_limit")->trigger();
        auto* const dialog = page.window().findChild<QInputDialog*>();
        QVERIFY(dialog);
        page.screenshot("recording-limit", dialog);
        auto* const box = dialog->findChild<QSpinBox*>();
        QCOMPARE(box->text(), QString("no limit"));
        box->selectAll();
        QTest::keyClicks(box, "4"); // Fewer than the least.
        QTest::keyClick(box, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.recording->limit_bytes == std::uint64_t(10'000'000), soon_ms);
        QVERIFY(page.notified("at most 10 MB").contains("recording"));
        QTRY_VERIFY_WITH_TIMEOUT(page.window().views().record->toolTip().contains("at most 10 MB"), soon_ms);
        QTRY_COMPARE_WITH_TIMEOUT(QSettings().value("record_limit_mb").toInt(), 10, soon_ms); // Saved each second.
    }
    WindowPage page({.settings_folder = settings.path()});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.recording, soon_ms);
    QCOMPARE(page.robot(1)->figures.recording->limit_bytes, mission::RecordingLimit(10'000'000));
}

void tst_WindowReplay::aFileThatIsNoRecordingIsRefusedWithAMend() {
    WindowPage page;
    page.window().control().openRecording(folder_.filePath("none.usarrec"));
    QTRY_VERIFY_WITH_TIMEOUT(page.notified("none.usarrec").contains("Check the name"), soon_ms);
}

bool tst_WindowReplay::exportsTo(WindowPage& page, const QString& file) {
    page.window().commands().action("file.export_recording")->trigger();
    auto* const dialog = page.window().findChild<QFileDialog*>();
    if (!dialog || !dialog->isVisible() || dialog->isModal())
        return false;
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file);
    for (QAbstractButton* button : dialog->findChildren<QAbstractButton*>())
        if (button->text().remove('&') == "Save")
            QTest::mouseClick(button, Qt::LeftButton);
    return true;
}

void tst_WindowReplay::theRecordingIsExported() {
    WindowPage page;
    QVERIFY(!page.window().commands().action("file.export_recording")->isEnabled());
    QVERIFY(opens(page));
    QVERIFY(page.window().commands().action("file.export_recording")->isEnabled());
    const QString file = folder_.filePath("flight.mcap");
    QVERIFY(exportsTo(page, folder_.filePath("flight"))); // The suffix is added.
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("Exported the recording to " + file).isEmpty(), soon_ms);
    page.screenshot("recording_exported");
    std::string trouble;
    const auto exported = doubles::readMcap(doubles::readAll(file.toStdString()), trouble);
    QVERIFY2(exported, trouble.c_str());
    QVERIFY(exported->of("/R1/scan/Scanner1").size() > 100 && !exported->of("/R1/map").empty());
    QVERIFY(!page.window().commands().action("file.cancel_saving")->isEnabled());
    QVERIFY(exportsTo(page, recording_ + "/flight.mcap"));
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("flight.mcap: cannot write").isEmpty(), soon_ms);
}

USAR_TEST(tst_WindowReplay)

} // namespace tst_window_replay

#include "tst_window_replay.moc"
