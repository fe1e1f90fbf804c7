// What the plan's panel has for a person who stops, steps and goes back: marks, bars, dialogs.
#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/plan/breakpoint_dialog.h"
#include "widgets/plan/plan_panel.h"
#include "widgets/style/theme.h"

namespace tst_plan_debugger {

using namespace usar;
using namespace usar::widgets;

namespace {

const std::string root = "/P:0/DC:0";

PlanTime timeOf(double shown_s, bool live) {
    PlanTime time;
    time.begin = Seconds{10.0};
    time.end = Seconds{90.0};
    time.shown = Seconds{shown_s};
    time.cycle = 7;
    time.live = live;
    return time;
}

QPushButton* okOf(const QDialog& dialog) {
    return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
}

/// How many pixels of an image differ from another's.
int differing(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < std::min(a.height(), b.height()); ++y)
        for (int x = 0; x < std::min(a.width(), b.width()); ++x)
            count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

} // namespace

class tst_PlanDebugger : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup() { panel_.reset(); }
    void eachKindOfMarkIsDrawn_data();
    void eachKindOfMarkIsDrawn();
    void marksAreSaidInWords();
    void theMenuIsAskedForByMouseAndKey();
    void haltBarSaysWhyAndOffersTheWayOn();
    void timeBarSaysWhichMomentIsShown_data();
    void timeBarSaysWhichMomentIsShown();
    void inThePastABroadBarSaysThatItCanBeReplayed_data();
    void inThePastABroadBarSaysThatItCanBeReplayed();
    void theSliderAsksForMoments();
    void keysAndWheelStepCycles_data();
    void keysAndWheelStepCycles();
    void theSliderKeepsTheKeysWhileThereIsNoRun();
    void theBreakpointListIsThereWhileThereAreAny();
    void breakpointsAreSwitchedAndTakenAwayInTheList();
    void theDialogTakesNoConditionThatIsNone();
    void theDialogGivesWhatIsTyped();
    void aPinIsAValueOrAnAnswer();

private:
    std::unique_ptr<PlanPanel> panel_;
};

void tst_PlanDebugger::init() {
    applyTheme(Theme::Dark);
    panel_ = std::make_unique<PlanPanel>();
    panel_->resize(1200, 600);
    panel_->setPlan(planOf(courier_plan));
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
}

void tst_PlanDebugger::eachKindOfMarkIsDrawn_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("kind");
    int kind = 0;
    for (const char* const name : {"breakpoint", "breakpoint that is off", "conditional", "pinned", "off", "halted"}) {
        QTest::addRow("%s on a drive", name) << QString::fromStdString(root + "/DE:0") << kind;
        QTest::addRow("%s on a sense", name) << QString::fromStdString(root + "/DE:0/S:0") << kind++;
    }
}

void tst_PlanDebugger::eachKindOfMarkIsDrawn() {
    QFETCH(QString, path);
    QFETCH(int, kind);
    PlanMark mark{.path = path.toStdString()};
    mark.breakpoints = kind == 0 || kind == 2;
    mark.breakpoints_off = kind == 1;
    mark.conditional = kind == 2;
    mark.pinned = kind == 3;
    mark.switched_off = kind == 4;
    mark.halted = kind == 5;
    PlanView& view = panel_->view();
    const QImage before = view.grab().toImage();
    view.setMarks({mark});
    QVERIFY(differing(before, view.grab().toImage()) > 20);
    view.setMarks({});
    QCOMPARE(differing(before, view.grab().toImage()), 0);
}

void tst_PlanDebugger::marksAreSaidInWords() {
    PlanView& view = panel_->view();
    view.setMarks({{.path = root + "/DE:0", .breakpoints = 1, .words = {QStringLiteral("Breakpoint: before")}}});
    const PlanNodeId node = view.tree().find(root + "/DE:0");
    QVERIFY(view.nodeText(node).contains(QStringLiteral("Breakpoint: before")));
    view.setPlan(planOf(courier_plan)); // as after an edit
    QVERIFY(view.marks().at(view.tree().find(root + "/DE:0")));
}

void tst_PlanDebugger::theMenuIsAskedForByMouseAndKey() {
    PlanView& view = panel_->view();
    QSignalSpy asked(&view, &PlanView::menuRequested);
    const PlanNodeId node = view.tree().find(root + "/DE:1");
    const QPoint at = view.toScreen(view.layout().box(view.tree(), node).center()).toPoint();
    QContextMenuEvent by_mouse(QContextMenuEvent::Mouse, at, view.mapToGlobal(at));
    QApplication::sendEvent(&view, &by_mouse);
    QCOMPARE(asked.count(), 1);
    QCOMPARE(asked.at(0).at(0).value<PlanNodeId>(), view.selected());
    view.select(node);
    QContextMenuEvent by_key(QContextMenuEvent::Keyboard, {}, {});
    QApplication::sendEvent(&view, &by_key);
    QCOMPARE(asked.at(1).at(0).value<PlanNodeId>(), node);
    QVERIFY(QRect(view.mapToGlobal(QPoint()), view.size()).contains(asked.at(1).at(1).toPoint()));
}

void tst_PlanDebugger::haltBarSaysWhyAndOffersTheWayOn() {
    PlanHaltBar& bar = panel_->haltBar();
    QAction go_on(QStringLiteral("Go on"));
    bar.setActions({&go_on});
    QVERIFY(!bar.isVisible());
    bar.setText(QStringLiteral("R1 stands still: before work"));
    QVERIFY(bar.isVisible());
    QSignalSpy triggered(&go_on, &QAction::triggered);
    QTest::mouseClick(bar.findChild<QToolButton*>(), Qt::LeftButton);
    QCOMPARE(triggered.count(), 1);
    bar.setText({});
    QVERIFY(!bar.isVisible());
}

void tst_PlanDebugger::timeBarSaysWhichMomentIsShown_data() {
    QTest::addColumn<PlanTime>("time");
    QTest::addColumn<QString>("words");
    PlanTime epoch = timeOf(22.4, false);
    epoch.epoch = 1;
    epoch.epochs = 3;
    PlanTime replay = timeOf(22.4, true);
    replay.replay = true;
    QTest::newRow("live") << timeOf(90.0, true) << "live, 80.0 s";
    QTest::newRow("before") << timeOf(22.4, false) << "at 12.4 s of 80.0 s";
    QTest::newRow("within a cycle") << epoch << "at 12.4 s of 80.0 s, decision 1 of 3";
    QTest::newRow("of a replay") << replay << "at 12.4 s of 80.0 s";
    QTest::newRow("nothing yet") << PlanTime() << "";
}

void tst_PlanDebugger::timeBarSaysWhichMomentIsShown() {
    QFETCH(PlanTime, time);
    QFETCH(QString, words);
    PlanTimeBar& bar = panel_->timeBar();
    bar.setTime(time);
    QCOMPARE(bar.findChild<QLabel*>()->text(), words);
    QCOMPARE(bar.slider()->isEnabled(), time.cycle != 0);
}

void tst_PlanDebugger::inThePastABroadBarSaysThatItCanBeReplayed_data() {
    QTest::addColumn<PlanTime>("time");
    QTest::addColumn<int>("width_px");
    QTest::addColumn<bool>("in_words");
    PlanTime replay = timeOf(22.4, true);
    replay.replay = true;
    QTest::newRow("the past") << timeOf(22.4, false) << 900 << true;
    QTest::newRow("the past, where there is no room") << timeOf(22.4, false) << 400 << false;
    QTest::newRow("now") << timeOf(90.0, true) << 900 << false;
    QTest::newRow("a replay") << replay << 900 << false;
}

void tst_PlanDebugger::inThePastABroadBarSaysThatItCanBeReplayed() {
    QFETCH(PlanTime, time);
    QFETCH(int, width_px);
    QFETCH(bool, in_words);
    PlanTimeBar bar;
    QAction other(QStringLiteral("Other"));
    QAction look_back(QStringLiteral("Replay from here"));
    bar.setActions(&other, &other, &other, &look_back, &other);
    bar.resize(width_px, 40);
    bar.show();
    bar.setTime(time);
    const auto buttons = bar.findChildren<QToolButton*>();
    const auto offers = [&](const QToolButton* button) { return button->defaultAction() == &look_back; };
    const auto found = std::ranges::find_if(buttons, offers);
    QVERIFY(found != buttons.end());
    QCOMPARE((*found)->toolButtonStyle() == Qt::ToolButtonTextBesideIcon, in_words);
}

void tst_PlanDebugger::theSliderAsksForMoments() {
    PlanTimeBar& bar = panel_->timeBar();
    bar.setTime(timeOf(90.0, true));
    QCOMPARE(bar.slider()->value(), bar.slider()->maximum());
    QSignalSpy asked(&bar, &PlanTimeBar::timeWanted);
    QTest::mouseClick(bar.slider(), Qt::LeftButton, {}, bar.slider()->rect().center());
    QVERIFY(asked.count() > 0);
    QVERIFY(std::abs(asked.last().at(0).value<Seconds>().count() - 50.0) < 2.0);
    bar.setTime(timeOf(50.0, false));
    QTest::keyClick(bar.slider(), Qt::Key_Home);
    QCOMPARE(asked.last().at(0).value<Seconds>(), Seconds{10.0});
}

void tst_PlanDebugger::keysAndWheelStepCycles_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("wheel");
    QTest::addColumn<int>("cycles");
    QTest::newRow("right") << int(Qt::Key_Right) << 0 << 1;
    QTest::newRow("left") << int(Qt::Key_Left) << 0 << -1;
    QTest::newRow("wheel up") << 0 << 120 << 1;
    QTest::newRow("wheel down, two notches") << 0 << -240 << -2;
    QTest::newRow("half a notch") << 0 << 60 << 0;
}

void tst_PlanDebugger::keysAndWheelStepCycles() {
    QFETCH(int, key);
    QFETCH(int, wheel);
    QFETCH(int, cycles);
    PlanTimeBar bar;
    QAction other;
    QAction back;
    QAction forward;
    bar.setActions(&other, &back, &forward, &other, &other);
    int stepped = 0;
    connect(&back, &QAction::triggered, &bar, [&stepped] { --stepped; });
    connect(&forward, &QAction::triggered, &bar, [&stepped] { ++stepped; });
    QSignalSpy asked(&bar, &PlanTimeBar::timeWanted);
    QSlider* const slider = bar.slider();
    const auto act = [&] {
        if (key != 0)
            return QTest::keyClick(slider, Qt::Key(key));
        QWheelEvent turn(slider->rect().center(), slider->mapToGlobal(slider->rect().center()), {}, {0, wheel},
                         Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(slider, &turn);
    };
    act();
    QCOMPARE(stepped, 0); // there is no run
    bar.setTime(timeOf(50.0, false));
    act();
    QCOMPARE(stepped, cycles);
    QCOMPARE(asked.count(), 0);
}

void tst_PlanDebugger::theSliderKeepsTheKeysWhileThereIsNoRun() {
    PlanTimeBar& bar = panel_->timeBar();
    bar.setTime(timeOf(50.0, false));
    panel_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(panel_.get()));
    bar.slider()->setFocus();
    bar.setTime({});
    bar.setTime(timeOf(20.0, true));
    QVERIFY(bar.slider()->hasFocus());
    panel_->clear(); // another robot's plan is on its way
    bar.setTime({});
    QVERIFY(!bar.isVisible());
    panel_->setPlan(planOf(courier_plan));
    bar.setTime(timeOf(20.0, false));
    QTRY_VERIFY(bar.slider()->hasFocus());
    panel_->view().setFocus();
    bar.setTime({});
    QVERIFY(!bar.slider()->isEnabled());
}

void tst_PlanDebugger::theBreakpointListIsThereWhileThereAreAny() {
    const auto list = [this] {
        for (QListWidget* each : panel_->findChildren<QListWidget*>())
            if (each->accessibleName() == QStringLiteral("Breakpoints"))
                return each;
        return static_cast<QListWidget*>(nullptr);
    }();
    QVERIFY(list && !list->isVisible());
    panel_->setBreakpoints({{1, QStringLiteral("work, before"), {}, root + "/DE:1", true}});
    QVERIFY(list->isVisible());
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(0)).center() + QPoint(20, 0));
    QCOMPARE(panel_->view().selected(), panel_->view().tree().find(root + "/DE:1"));
    panel_->setBreakpoints({});
    QVERIFY(!list->isVisible());
}

void tst_PlanDebugger::breakpointsAreSwitchedAndTakenAwayInTheList() {
    QListWidget* list = nullptr;
    for (QListWidget* each : panel_->findChildren<QListWidget*>())
        if (each->accessibleName() == QStringLiteral("Breakpoints"))
            list = each;
    std::vector<BreakpointRow> rows{{4, QStringLiteral("work, before"), {}, root + "/DE:1", true},
                                    {5, QStringLiteral("gone, before"), {}, {}, true}};
    panel_->setBreakpoints(rows);
    QSignalSpy switched(panel_.get(), &PlanPanel::breakpointSwitched);
    QSignalSpy removed(panel_.get(), &PlanPanel::breakpointRemoved);
    connect(panel_.get(), &PlanPanel::breakpointSwitched, this, [&](agent::BreakpointId, bool on) {
        rows[0].enabled = on;
        panel_->setBreakpoints(rows); // in the midst of it, as the window does
    });
    list->setFocus();
    list->setCurrentRow(0);
    QTest::keyClick(list, Qt::Key_Space);
    QCOMPARE(switched.count(), 1);
    QCOMPARE(switched.at(0).at(0).value<agent::BreakpointId>(), agent::BreakpointId{4});
    QCOMPARE(switched.at(0).at(1).toBool(), false);
    QCOMPARE(list->item(0)->checkState(), Qt::Unchecked);
    list->setCurrentRow(1);
    QTest::keyClick(list, Qt::Key_Delete);
    QCOMPARE(removed.count(), 1);
    QCOMPARE(removed.at(0).at(0).value<agent::BreakpointId>(), agent::BreakpointId{5});
}

void tst_PlanDebugger::theDialogTakesNoConditionThatIsNone() {
    posh::Breakpoint breakpoint;
    breakpoint.names = "courier ▸ work";
    BreakpointDialog dialog(breakpoint, nullptr);
    QVERIFY(okOf(dialog)->isEnabled());
    auto* condition = dialog.findChild<QLineEdit*>();
    QTest::keyClicks(condition, QStringLiteral("(near 0.3 <"));
    QVERIFY(!okOf(dialog)->isEnabled());
    QTest::keyClicks(condition, QStringLiteral(")"));
    QVERIFY(okOf(dialog)->isEnabled());
    QCOMPARE(dialog.breakpoint().condition, std::string("(near 0.3 <)"));
}

void tst_PlanDebugger::theDialogGivesWhatIsTyped() {
    posh::Breakpoint breakpoint;
    breakpoint.names = "courier ▸ work";
    breakpoint.path = root + "/DE:1";
    breakpoint.on = posh::BreakOn::Result;
    breakpoint.result = posh::ActResult::Running;
    breakpoint.skip = 3;
    breakpoint.once = true;
    BreakpointDialog dialog(breakpoint, nullptr);
    QVERIFY(dialog.breakpoint() == breakpoint);
    dialog.findChild<QComboBox*>()->setCurrentIndex(1);
    dialog.findChild<QSpinBox*>()->setValue(1);
    breakpoint.on = posh::BreakOn::After;
    breakpoint.skip = 0;
    QVERIFY(dialog.breakpoint() == breakpoint);
}

void tst_PlanDebugger::aPinIsAValueOrAnAnswer() {
    const PinDialog sense(QStringLiteral("near"), QStringLiteral("0.5"), nullptr);
    QVERIFY(okOf(sense)->isEnabled());
    QCOMPARE(std::get<double>(*sense.answer()), 0.5);
    auto* line = sense.findChild<QLineEdit*>();
    line->selectAll();
    QTest::keyClicks(line, QStringLiteral("1 2"));
    QVERIFY(!okOf(sense)->isEnabled() && !sense.answer());
    const PinDialog act(QStringLiteral("walk"), std::nullopt, nullptr);
    QVERIFY(okOf(act)->isEnabled() && !act.answer());
    QCOMPARE(act.result(), posh::ActResult::Failed);
    act.findChild<QComboBox*>()->setCurrentIndex(1);
    QCOMPARE(act.result(), posh::ActResult::Running);
}

USAR_TEST(tst_PlanDebugger)

} // namespace tst_plan_debugger

#include "tst_plan_debugger.moc"
