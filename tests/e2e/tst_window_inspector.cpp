// The message inspector in the real window, by mouse and keys, against the simulator.
#include <QClipboard>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/inspector_page.h"
#include "tests/suite/suite.h"

namespace tst_window_inspector {

using namespace usar;

namespace {

/// A window with a robot in it and its messages in sight.
struct Opened {
    explicit Opened(const WindowSetup& setup = {}) : page(setup) {}
    bool ready() {
        if (!QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms) || !page.spawnAt("PlayerStart"))
            return false;
        page.pressKey(Qt::Key_F, Qt::ControlModifier);
        return QTest::qWaitFor([&] { return inspector.rows() > 20; }, soon_ms);
    }
    WindowPage page;
    InspectorPage inspector{page};
};

} // namespace

class tst_WindowInspector : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void linesAreFilteredByTextNameTypeAndDirection();
    void aHeldListStandsStill();
    void aLineIsCopiedAndACommandIsSentAgain();
    void aCommandLeadsToTheLineThatCausedIt();
    void aCompletedCommandMovesTheRobot();
    void anErrorIsSaidByColumnAndNotSentAtOnce();
    void historyOutlivesTheWindow();
    void withoutAConnectionNothingIsSent();
    void countersAreInSight();
    void messagesOfTwoRobotsAreToldApart();
};

void tst_WindowInspector::linesAreFilteredByTextNameTypeAndDirection() {
    Opened o;
    QVERIFY(o.ready());
    InspectorPage& inspector = o.inspector;
    const auto isType = [](const char* type) {
        return [type](const widgets::MessageRow& row) { return row.type == type; };
    };
    inspector.filterBy("search", "sonar");
    QTRY_VERIFY(inspector.rows() > 2);
    QVERIFY(
        inspector.allRows([](const widgets::MessageRow& row) { return row.type.find("Sonar") != std::string::npos; }));
    inspector.filterBy("search", "/sen.*type ins/");
    QTRY_VERIFY(inspector.allRows(isType("SEN INS")));
    inspector.filterBy("search", {});
    inspector.filterBy("name", "groundtruth");
    QTRY_VERIFY(inspector.allRows(isType("SEN GroundTruth")));
    inspector.filterBy("name", {});
    inspector.chooseTypes({"SEN INS", "SEN Sonar"});
    QTRY_VERIFY(inspector.allRows(
        [](const widgets::MessageRow& row) { return row.type == "SEN INS" || row.type == "SEN Sonar"; }));
    o.page.pressKey(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier); // all again
    inspector.chooseDirection("→ out");
    QTRY_VERIFY(
        inspector.allRows([](const widgets::MessageRow& row) { return row.direction == widgets::Direction::Out; }));
    QVERIFY(inspector.rowOf("STEP") >= 0); // every line
    QTRY_VERIFY2(inspector.count().contains(" of "), qPrintable(inspector.count()));
    o.page.screenshot("inspector");
}

void tst_WindowInspector::aHeldListStandsStill() {
    Opened o;
    QVERIFY(o.ready());
    o.inspector.pressButton("messages.pause");
    const int before = o.inspector.rows();
    QTRY_VERIFY_WITH_TIMEOUT(o.inspector.count().contains("waiting"), soon_ms);
    QVERIFY(o.page.holdsWhileClockGoesOn([&] { return o.inspector.rows() == before; }, Seconds(0.6)));
    o.page.pressKey(Qt::Key_F8);
    QTRY_VERIFY(o.inspector.rows() > before);
    QVERIFY(!o.inspector.count().contains("waiting"));
}

void tst_WindowInspector::aLineIsCopiedAndACommandIsSentAgain() {
    Opened o;
    QVERIFY(o.ready());
    const std::string question = "GETCONF {Type Sonar}";
    o.inspector.type(QString::fromStdString(question));
    o.inspector.press(Qt::Key_Escape);
    o.inspector.press(Qt::Key_Return);
    const auto answers = [&] {
        int count = 0;
        for (int row = 0; row < o.inspector.rows(); ++row)
            count += o.inspector.list().model().row(row).type == "CONF Sonar";
        return count;
    };
    QTRY_VERIFY(o.inspector.rowOf(question) >= 0);
    QTRY_VERIFY_WITH_TIMEOUT(answers() >= 1, soon_ms);
    o.inspector.chooseTypes({"GETCONF Sonar", "CONF Sonar"});
    QTRY_VERIFY(o.inspector.countOf(question) >= 1);
    const int asked = o.inspector.countOf(question);
    o.inspector.clickRow(o.inspector.rowOf(question));
    QVERIFY(o.inspector.list().view()->hasFocus());
    o.page.pressKey(Qt::Key_C, Qt::ControlModifier);
    QVERIFY2(QGuiApplication::clipboard()->text().endsWith("out\tGETCONF Sonar\tGETCONF {Type Sonar}"),
             qPrintable(QGuiApplication::clipboard()->text()));
    o.page.pressKey(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(o.inspector.countOf(question), asked + 1);
    const widgets::MessageRow& again = o.inspector.list().model().row(o.inspector.rowOf(question));
    QVERIFY2(again.note.starts_with("operator: resend"), again.note.c_str());
    QTRY_VERIFY_WITH_TIMEOUT(answers() >= 2, soon_ms); // the simulator heard both
}

void tst_WindowInspector::aCommandLeadsToTheLineThatCausedIt() {
    Opened o;
    QVERIFY(o.ready());
    o.inspector.chooseTypes({"STEP"});
    QTRY_VERIFY(o.inspector.rows() > 2);
    o.inspector.pressButton("messages.follow"); // or rows go on moving
    o.inspector.clickRow(1);
    o.inspector.pressButton("messages.details");
    const auto text = [&] { return o.inspector.list().detail()->toPlainText(); };
    QTRY_VERIFY2(text().contains("Sent by session: lockstep, on line "), qPrintable(text()));
    o.page.pressKey(Qt::Key_J, Qt::ControlModifier);
    QTRY_VERIFY2(text().startsWith("STA "), qPrintable(text()));
    QVERIFY2(text().contains("It made us send STEP"), qPrintable(text()));
    QVERIFY2(text().contains(" s"), qPrintable(text()));
    QVERIFY(o.inspector.list().view()->currentIndex().isValid());
    o.page.screenshot("inspector-details");
}

void tst_WindowInspector::aCompletedCommandMovesTheRobot() {
    Opened o;
    QVERIFY(o.ready());
    QTRY_VERIFY(o.page.robot(1)->base_in_map.has_value());
    const double before_m = o.page.robot(1)->base_in_map->position_m.z();
    o.inspector.type("driv");
    QTRY_VERIFY(o.inspector.box().completer()->popup()->isVisible());
    o.inspector.press(Qt::Key_Tab);
    QCOMPARE(o.inspector.box().line()->text(), QString("DRIVE "));
    QTest::keyClicks(o.inspector.box().line(), "{alt");
    o.inspector.press(Qt::Key_Tab);
    QTest::keyClicks(o.inspector.box().line(), "1.5}");
    QCOMPARE(o.inspector.box().line()->text(), QString("DRIVE {AltitudeVelocity 1.5}"));
    o.inspector.press(Qt::Key_Escape);
    o.inspector.press(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(o.page.robot(1)->base_in_map->position_m.z() > before_m + 1.0, soon_ms);
    QTRY_VERIFY(o.inspector.rowOf("DRIVE {AltitudeVelocity 1.5}") >= 0);
    const auto& row = o.inspector.list().model().row(o.inspector.rowOf("DRIVE {AltitudeVelocity 1.5}"));
    QVERIFY2(row.note.starts_with("operator: command box"), row.note.c_str());
    QVERIFY(o.inspector.box().line()->text().isEmpty());
}

void tst_WindowInspector::anErrorIsSaidByColumnAndNotSentAtOnce() {
    Opened o;
    QVERIFY(o.ready());
    const std::string wrong = "DRIVE {AltitudeVelocity fast}";
    o.inspector.type(QString::fromStdString(wrong));
    o.inspector.press(Qt::Key_Escape);
    o.inspector.press(Qt::Key_Return);
    QVERIFY2(o.inspector.box().complaint().contains("Column 25: "), qPrintable(o.inspector.box().complaint()));
    QCOMPARE(o.inspector.box().line()->diagnostics().size(), std::size_t(1));
    o.page.screenshot("inspector-error");
    QVERIFY(o.page.holdsWhileClockGoesOn([&] { return o.inspector.rowOf(wrong) == -1; }, Seconds(0.4)));
    o.inspector.press(Qt::Key_Return);
    QTRY_VERIFY(o.inspector.rowOf(wrong) >= 0);
}

void tst_WindowInspector::historyOutlivesTheWindow() {
    const QTemporaryDir settings;
    const WindowSetup setup{.settings_folder = settings.path()};
    {
        Opened o(setup);
        QVERIFY(o.ready());
        o.inspector.type("GETGEO {Type Robot}");
        o.inspector.press(Qt::Key_Escape);
        o.inspector.press(Qt::Key_Return);
        o.page.window().quit();
        QTRY_VERIFY_WITH_TIMEOUT(!o.page.window().isVisible(), soon_ms);
    }
    WindowPage page(setup);
    InspectorPage inspector(page);
    inspector.type({});
    inspector.press(Qt::Key_Up);
    QCOMPARE(inspector.box().line()->text(), QString("GETGEO {Type Robot}"));
}

void tst_WindowInspector::withoutAConnectionNothingIsSent() {
    WindowPage page;
    InspectorPage inspector(page);
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().commands().action("link.disconnect")->trigger();
    inspector.type("GETSTARTPOSES");
    inspector.press(Qt::Key_Escape);
    inspector.press(Qt::Key_Return);
    QVERIFY2(inspector.box().complaint().contains("There is no connection to send it on. Connect to a server first."),
             qPrintable(inspector.box().complaint()));
    QCOMPARE(inspector.box().line()->text(), QString("GETSTARTPOSES"));
}

void tst_WindowInspector::countersAreInSight() {
    Opened o;
    QVERIFY(o.ready());
    QTRY_VERIFY(o.page.window().views().traffic->text().contains("no errors"));
    o.page.pressKey(Qt::Key_F9);
    auto* panel = o.page.window().views().connection->panel();
    QTRY_VERIFY(panel->isVisible());
    const auto said = [&](const char* name) {
        for (const QLabel* label : panel->findChildren<QLabel*>())
            if (label->accessibleName() == name)
                return label->text();
        return QString();
    };
    QTRY_VERIFY(said("Lines in").toInt() > 20);
    QTRY_VERIFY(said("Lines out per second").toInt() > 0); // STEP
    QCOMPARE(said("Dropped"), QString("0"));
    QTRY_VERIFY2(said("Round trip").section(' ', 0, 0).toDouble() > 0.0, qPrintable(said("Round trip")));
    panel->close();
}

void tst_WindowInspector::messagesOfTwoRobotsAreToldApart() {
    Opened o;
    QVERIFY(o.ready());
    o.page.window().commands().action("view.operate")->trigger();
    QVERIFY(o.page.spawnAt("HillTop"));
    o.page.pressKey(Qt::Key_F, Qt::ControlModifier);
    const auto robotOf = [&](const widgets::MessageRow& row) {
        return o.inspector.list().model().connectionName(row.connection);
    };
    QTRY_VERIFY(o.inspector.allRows([&](const widgets::MessageRow& row) { return robotOf(row) == "R2"; }));
    o.page.window().commands().action("messages.all_robots")->trigger();
    QTRY_VERIFY(!o.inspector.allRows([&](const widgets::MessageRow& row) { return robotOf(row) == "R2"; }));
    QVERIFY(!o.inspector.list().view()->isColumnHidden(widgets::MessageModel::Robot));
}

USAR_TEST(tst_WindowInspector)

} // namespace tst_window_inspector

#include "tst_window_inspector.moc"
