// What a killed window leaves, and what the next one makes of it.
#include <algorithm>

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QTest>

#include "tests/doubles/crashed_run.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/bars/strips.h"
#include "widgets/style/theme.h"

namespace tst_window_crash {

using namespace usar;

namespace {

QByteArray missionOver(const Rectangle& area) {
    return QString("{ \"name\": \"Cut\", \"area\": { \"x\": %1, \"y\": %2, \"width\": %3, \"height\": %4 },"
                   " \"adjust\": true, \"limit_h\": 3 }")
        .arg(area.min_m.x())
        .arg(area.min_m.y())
        .arg(area.width_m())
        .arg(area.height_m())
        .toUtf8();
}

/// The line of the settings that begins so; empty where there is none.
QByteArray lineOf(const QByteArray& settings, const QByteArray& beginning) {
    for (const QByteArray& line : settings.split('\n'))
        if (line.startsWith(beginning))
            return line;
    return {};
}

} // namespace

class tst_WindowCrash : public QObject {
    Q_OBJECT
private slots:
    void init() {
        GuiWatchdog::instance().reset();
        settings_ = std::make_unique<QTemporaryDir>();
        results_ = std::make_unique<QTemporaryDir>();
    }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }

    void whatIsChangedSurvivesAKill() {
        const QTemporaryDir of_killed;
        std::optional<Rectangle> area_in_map;
        {
            WindowPage page({.settings_folder = of_killed.path()});
            QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
            const auto text = [&] {
                QFile file(of_killed.filePath(settings_file));
                return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
            };
            const auto docks = [&] { return lineOf(text(), "layout="); };
            QTRY_VERIFY_WITH_TIMEOUT(!docks().isEmpty(), soon_ms);
            const QByteArray docks_before = docks();
            page.window().commands().action("view.dark")->trigger();
            page.window().commands().action("view.dock.robots")->trigger();
            page.pressKey(Qt::Key_A);
            page.drawArea({{-10.0, -8.0}, {10.0, 8.0}});
            area_in_map = page.map().area();
            QVERIFY(area_in_map.has_value());
            const auto isWritten = [&] {
                const QByteArray now = text();
                return now.contains("theme=light") && now.contains("max_x_m=") && !now.contains("max_x_m=0") &&
                       lineOf(now, "layout=") != docks_before;
            };
            QTRY_VERIFY_WITH_TIMEOUT(isWritten(), soon_ms);
            QVERIFY(QDir(settings_->path()).mkpath("USAR"));
            QVERIFY(QFile::copy(of_killed.filePath(settings_file), settings_->filePath(settings_file)));
        }
        WindowPage page({.settings_folder = settings_->path()});
        QCOMPARE(widgets::currentTheme(), widgets::Theme::Light);
        QVERIFY(page.window().findChild<QDockWidget*>("robots")->isHidden());
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QTRY_VERIFY_WITH_TIMEOUT(page.map().area() == area_in_map, soon_ms);
    }

    void whatIsRecordedIsMarkedUntilTheEnd() {
        {
            WindowPage page(setup());
            QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
            QVERIFY(page.spawnAt("PlayerStart"));
            QTRY_COMPARE_WITH_TIMEOUT(QDir(marks()).entryList({"*.txt"}, QDir::Files).size(), 1, soon_ms);
            QFile list(QDir(marks()).filePath(QDir(marks()).entryList({"*.txt"}, QDir::Files).front()));
            QTRY_VERIFY_WITH_TIMEOUT(list.size() > 0, soon_ms);
            QVERIFY(list.open(QIODevice::ReadOnly));
            const QString path = QString::fromUtf8(list.readAll());
            QCOMPARE(QFileInfo(path).path(), QFileInfo(page.resultFolder()).absoluteFilePath());
            QVERIFY(QFileInfo::exists(path));
        }
        QVERIFY(QDir(marks()).entryList(QDir::Files).isEmpty());
        WindowPage next(setup());
        QVERIFY(next.window().views().question->openQuestion().isEmpty());
    }

    void theNextStartOffersTheRecording() {
        leaveRecording();
        {
            WindowPage page(setup());
            auto* const question = page.window().views().question;
            QTRY_COMPARE_WITH_TIMEOUT(question->openQuestion(), QString("recovery"), soon_ms);
            QTRY_VERIFY(question->isVisible());
            page.screenshot("after_a_kill");
            page.press("Open the recording");
            QVERIFY(question->isHidden());
            QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && !page.robot(1)->recording.isEmpty(), soon_ms);
        }
        WindowPage again(setup());
        QVERIFY(again.window().views().question->openQuestion().isEmpty());
    }

    void theRestOfAMissionIsFlown() {
        const Rectangle whole{{-12.0, -12.0}, {12.0, 12.0}};
        const QString recording = cutOffRecording(whole);
        QVERIFY(!recording.isEmpty());
        QVERIFY(doubles::leaveAsIfKilled(marks(), {recording}));
        WindowPage page(setup());
        auto* const question = page.window().views().question;
        QTRY_COMPARE_WITH_TIMEOUT(question->openQuestion(), QString("recovery"), soon_ms);
        page.screenshot("fly_the_rest");
        page.press("Fly the rest");
        QTRY_VERIFY2_WITH_TIMEOUT(page.robot(1) && page.window().control().robot({1})->running(),
                                  qPrintable(page.notified({})), soon_ms);
        const auto started = page.window().control().robot({1})->started();
        QVERIFY(started && started->continues);
        const auto isSaid = [](const QLabel* label) { return label->text().contains("On its way"); };
        QTRY_VERIFY(std::ranges::any_of(page.window().views().hint->findChildren<QLabel*>(), isSaid));
        QVERIFY(whole.contains(started->area_in_map) && started->area_in_map.area_m2() < whole.area_m2());
        QCOMPARE(page.robot(1)->area_in_map, whole);
        QVERIFY(page.robot(1)->adjust);
        QCOMPARE(page.robot(1)->limit_h, std::optional(3.0));
        const auto map_is_there = [&] {
            const auto covered_pct = page.window().control().robot({1})->coverage_pct();
            return covered_pct && *covered_pct > 20.0;
        };
        QTRY_VERIFY_WITH_TIMEOUT(map_is_there(), soon_ms);
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->status, soon_ms);
        QVERIFY(page.robot(1)->status->progress_pct.value_or(0.0) < 20.0);
    }

    void nothingIsOpenedWhereTheAnswerIsNo() {
        leaveRecording();
        WindowPage page(setup());
        auto* const question = page.window().views().question;
        QTRY_COMPARE_WITH_TIMEOUT(question->openQuestion(), QString("recovery"), soon_ms);
        question->give(1);
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QVERIFY(page.window().control().robots().empty());
    }

    void otherQuestionsGoFirst() {
        leaveRecording();
        WindowPage page(setup());
        auto* const question = page.window().views().question;
        QTRY_COMPARE_WITH_TIMEOUT(question->openQuestion(), QString("recovery"), soon_ms);
        question->ask("other", "Is it urgent?", {{"Yes", {}}, {"No", {}}});
        question->give(0);
        QCOMPARE(question->openQuestion(), QString("recovery"));
        question->give(1);
        QVERIFY(question->openQuestion().isEmpty());
        QVERIFY(question->isHidden());
    }

private:
    WindowSetup setup() const { return {.result_folder = results_->path(), .settings_folder = settings_->path()}; }
    QString marks() const { return settings_->filePath("USAR/running"); }

    /// A recording whose program was killed.
    void leaveRecording() const {
        QString recording;
        {
            WindowPage page({.result_folder = results_->path()});
            QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
            QVERIFY(page.spawnAt("PlayerStart"));
            page.window().control().remove({1});
            QTRY_VERIFY_WITH_TIMEOUT(!page.endedRecording().isEmpty(), soon_ms);
            recording = page.endedRecording();
        }
        QVERIFY(doubles::leaveAsIfKilled(marks(), {recording}));
    }

    /// A recording that breaks off when half of the mission was flown; empty if it could not be made. The whole
    /// mission is flown and the file cut, because a program that is killed on a busy machine may have finished.
    QString cutOffRecording(const Rectangle& area) const {
        QFile mission(results_->filePath("cut.json"));
        if (!mission.open(QIODevice::WriteOnly))
            return {};
        mission.write(missionOver(area));
        mission.close();
        const QString path = results_->filePath("cut.usarrec");
        QProcess program;
        program.start(USAR_BINARY_DIR "/bin/usar-mission",
                      {"run", mission.fileName(), "--out", results_->path(), "--record", path});
        if (!program.waitForFinished(soon_ms))
            return {};
        QFile recording(path);
        return recording.resize(recording.size() / 2) ? path : QString();
    }

    const QString settings_file = "USAR/Mission Control.conf";
    std::unique_ptr<QTemporaryDir> settings_;
    std::unique_ptr<QTemporaryDir> results_;
};

USAR_TEST(tst_WindowCrash)

} // namespace tst_window_crash

#include "tst_window_crash.moc"
