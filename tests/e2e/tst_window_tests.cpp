// Tests of moments: made in the window, of a robot that flies and of a recording.
#include <QDir>
#include <QListWidget>
#include <QTest>

#include "core/mission/files/mission_file.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/panels/test_dialog.h"

namespace tst_window_tests {

using namespace usar;

class tst_WindowTests : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }

    void aTestIsMadeWhileTheRobotFliesAndOfItsRecording() {
        const QTemporaryDir folder;
        WindowPage page({.result_folder = folder.path()});
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QVERIFY(!page.window().commands().action("replay.make_test")->isEnabled());
        QVERIFY(page.spawnAt("PlayerStart"));
        page.pressKey(Qt::Key_A);
        page.drawArea({{-15, -10}, {15, 10}});
        page.press("Start");
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->status && page.robot(1)->figures.recording, soon_ms);
        widgets::TestDialog* const live = asked(page);
        QVERIFY(live);
        page.screenshot("test_of_a_moment");
        QVERIFY(choose(*live, "no contact"));
        make(*live, "While it flies");
        const auto first = made(folder, "While it flies");
        QVERIFY2(first, first ? "" : first.error().text().c_str());
        QVERIFY(first->claims.front().kind == mission::ClaimKind::NoContact);
        QVERIFY(first->seed.has_value());
        QVERIFY((first->area_in_map == Rectangle{{-15, -10}, {15, 10}}));
        QVERIFY(page.notified("While it flies.json").contains("campaign --tests"));

        page.chooseSpeed("max");
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished.has_value(), flight_ms);
        page.window().control().remove({1});
        QTRY_VERIFY_WITH_TIMEOUT(!page.endedRecording().isEmpty(), soon_ms);
        const QString recording = page.endedRecording();
        page.window().control().openRecording(recording);
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(page.window().selectedRobot()) &&
                                     page.robot(page.window().selectedRobot())->figures.replay,
                                 soon_ms);
        const RobotId id = page.window().selectedRobot();
        page.window().control().robot(id)->orderReplay({.seek = page.robot(id)->figures.replay->span * 0.5});
        const auto arrived = [&] {
            const auto& replay = page.robot(id)->figures.replay;
            return replay && !replay->seeking && replay->position >= replay->span * 0.49;
        };
        QTRY_VERIFY_WITH_TIMEOUT(arrived() && !page.robot(id)->behavior_id.empty(), soon_ms);
        widgets::TestDialog* const replayed = asked(page);
        QVERIFY(replayed);
        QVERIFY(choose(*replayed, "altitude above"));
        make(*replayed, "While it flies"); // There is one of that name.
        QTest::qWait(1);
        QVERIFY(replayed->isVisible());
        QVERIFY(made(folder, "While it flies")->claims.front().kind == mission::ClaimKind::NoContact);
        make(*replayed, "High enough");
        const auto second = made(folder, "High enough");
        QVERIFY2(second, second ? "" : second.error().text().c_str());
        QVERIFY(second->claims.front().kind == mission::ClaimKind::AltitudeAbove);
        QVERIFY(second->claims.front().height_m > 0.0);
        QVERIFY(second->seed == first->seed);
    }

private:
    /// Presses the keys; returns the dialog once it offers claims.
    static widgets::TestDialog* asked(WindowPage& page) {
        page.window().activateWindow(); // The dialog before had the keys.
        if (!QTest::qWaitForWindowActive(&page.window()))
            return nullptr;
        page.pressKey(Qt::Key_T, Qt::ControlModifier | Qt::AltModifier);
        widgets::TestDialog* found = nullptr;
        const bool offers = QTest::qWaitFor(
            [&] {
                found = page.window().findChild<widgets::TestDialog*>();
                return found && found->isVisible() && found->chosen() >= 0;
            },
            soon_ms);
        if (!offers)
            qWarning("%s, the command is %s", found ? "the dialog offers nothing" : "there is no dialog",
                     page.window().commands().action("replay.make_test")->isEnabled() ? "enabled" : "disabled");
        return offers ? found : nullptr;
    }

    static bool choose(const widgets::TestDialog& dialog, const QString& begin) {
        auto* const list = dialog.findChild<QListWidget*>();
        for (int row = 0; row < list->count(); ++row)
            if (list->item(row)->text().startsWith(begin)) {
                list->scrollToItem(list->item(row));
                QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(row)).center());
                return dialog.chosen() == row;
            }
        return false;
    }

    static void make(const widgets::TestDialog& dialog, const QString& name) {
        auto* const line = dialog.findChild<QLineEdit*>();
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, name);
        for (auto* const button : dialog.findChildren<QPushButton*>())
            if (button->text() == "Make test")
                QTest::mouseClick(button, Qt::LeftButton);
    }

    static Result<mission::Mission> made(const QTemporaryDir& folder, const QString& name) {
        return mission::readMissionFile(folder.filePath("tests/" + name + ".json"));
    }
};

USAR_TEST(tst_WindowTests)

} // namespace tst_window_tests

#include "tst_window_tests.moc"
