#include <algorithm>

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QShortcut>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>
#include <QTextBlock>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/plan/plan_panel.h"
#include "widgets/style/theme.h"

namespace tst_plan_panel {

using namespace usar;
using namespace usar::widgets;

namespace {

const std::string root = "/P:0/DC:0";

PlanSnapshot working() {
    PlanSnapshot snapshot;
    snapshot.now = Seconds(20.0);
    snapshot.activities.resize(4);
    for (int i = 0; i < 3; ++i)
        snapshot.activities[static_cast<std::size_t>(i)].running = true;
    snapshot.activities[3].answer = SenseAnswer{QStringLiteral("false"), false, Seconds(12.0), Seconds(20.0)};
    snapshot.paths = std::make_shared<const std::vector<std::string>>(
        std::vector<std::string>{root, root + "/DE:1", root + "/DE:1/A:0/C:0", root + "/DE:0/S:0"});
    return snapshot;
}

} // namespace

class tst_PlanPanel : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void runningListJumps();
    void reasonsNameSenseValueAndSince();
    void reasonsJumpToTheirSense();
    void aReasonLeadsToItsTime_data();
    void aReasonLeadsToItsTime();
    void aDoubleClickIsMeantForTheRowThatWasThere();
    void aReasonWithoutATimeLeadsToNone();
    void aChosenSenseIsExplainedOnce();
    void listsOfALowPanelStandBehindTabs();
    void nothingSelectedListsWhatPreventsTheDrives();
    void nothingToListSaysWhatToDo();
    void searchCountsAndSteps();
    void returnStepsAndEscapeGoesBack();
    void itsKeysAreItsOwnInAWindowThatHasThemToo();
    void sharedPartsAreSwitched();
    void buttonsFoldAndUnfold();
    void textAndDrawingGoTogether();
    void errorsOpenTheText();
    void narrowPanelStacks();
    void buttonsHaveNames();
    void newsKeepsTheChosenRow();

private:
    QListWidget* list(const char* name) const;
    /// The place of the only reason with these words, in pixels of the list's viewport.
    QPoint reasonAt(const char* words) const;
    QAbstractButton* button(const QString& part) const;
    std::unique_ptr<PlanPanel> panel_;
    std::unique_ptr<QSignalSpy> taken_; ///< one entry for each snapshot that was taken
};

void tst_PlanPanel::init() {
    applyTheme(Theme::Dark);
    panel_ = std::make_unique<PlanPanel>();
    taken_ = std::make_unique<QSignalSpy>(&panel_->view(), &PlanView::refreshed);
    panel_->resize(1200, 600);
    panel_->setPlan(planOf(courier_plan));
    panel_->setSnapshot(working());
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
    QTRY_COMPARE(taken_->count(), 1);
}

void tst_PlanPanel::cleanup() {
    taken_.reset();
    panel_.reset();
}

QListWidget* tst_PlanPanel::list(const char* name) const {
    for (QListWidget* list : panel_->findChildren<QListWidget*>())
        if (list->accessibleName() == QLatin1String(name))
            return list;
    return nullptr;
}

QPoint tst_PlanPanel::reasonAt(const char* words) const {
    const auto rows = list("Reasons")->findItems(QLatin1String(words), Qt::MatchContains);
    return rows.size() == 1 ? list("Reasons")->visualItemRect(rows[0]).center() : QPoint(-1, -1);
}

QAbstractButton* tst_PlanPanel::button(const QString& part) const {
    for (QAbstractButton* button : panel_->findChildren<QAbstractButton*>())
        if (button->toolTip().contains(part))
            return button;
    return nullptr;
}

void tst_PlanPanel::runningListJumps() {
    QListWidget* running = list("Running now");
    QCOMPARE(running->count(), 3);
    QCOMPARE(running->item(2)->text().trimmed(), QStringLiteral("fetch"));
    QTest::mouseClick(running->viewport(), Qt::LeftButton, {}, running->visualItemRect(running->item(2)).center());
    QCOMPARE(panel_->view().selected(), panel_->view().tree().find(root + "/DE:1/A:0/C:0"));
}

void tst_PlanPanel::reasonsNameSenseValueAndSince() {
    panel_->view().selectPath(root + "/DE:0");
    QListWidget* reasons = list("Reasons");
    QStringList texts;
    for (int i = 0; i < reasons->count(); ++i)
        texts << reasons->item(i)->text();
    QVERIFY2(texts.contains(QStringLiteral("safety: Bumped – no, it is false, for 8.0 s")),
             qPrintable(texts.join('\n')));
}

void tst_PlanPanel::reasonsJumpToTheirSense() {
    panel_->view().selectPath(root + "/DE:0/A:0");
    QListWidget* reasons = list("Reasons");
    const auto rows = reasons->findItems(QStringLiteral("Bumped"), Qt::MatchContains);
    QCOMPARE(rows.size(), 1);
    emit reasons->itemActivated(rows[0]);
    QCOMPARE(panel_->view().selected(), panel_->view().tree().find(root + "/DE:0/S:0"));
}

void tst_PlanPanel::aReasonLeadsToItsTime_data() {
    QTest::addColumn<bool>("by_key");
    QTest::addColumn<std::string>("selected");
    QTest::newRow("double-click") << false << root + "/DE:0";
    QTest::newRow("Return") << true << root + "/DE:0";
    QTest::newRow("double-click with nothing selected") << false << std::string();
    QTest::newRow("Return with nothing selected") << true << std::string();
}

void tst_PlanPanel::aReasonLeadsToItsTime() {
    QFETCH(bool, by_key);
    QFETCH(std::string, selected);
    if (!selected.empty())
        panel_->view().selectPath(selected);
    QSignalSpy asked(&panel_->timeBar(), &PlanTimeBar::timeWanted);
    QListWidget* reasons = list("Reasons");
    const QPoint at = reasonAt("Bumped");
    QTest::mouseClick(reasons->viewport(), Qt::LeftButton, {}, at);
    QCOMPARE(panel_->view().selected(), panel_->view().tree().find(root + "/DE:0/S:0"));
    QVERIFY(asked.isEmpty()); // one click only selects
    if (by_key) {
        reasons->setCurrentItem(reasons->itemAt(reasonAt("Bumped")));
        QTest::keyClick(reasons, Qt::Key_Return);
    } else {
        QTest::mouseDClick(reasons->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseRelease(reasons->viewport(), Qt::LeftButton, {}, at);
    }
    QCOMPARE(asked.size(), 1);
    QCOMPARE(asked[0][0].value<Seconds>(), Seconds(12.0));
}

void tst_PlanPanel::aDoubleClickIsMeantForTheRowThatWasThere() {
    PlanSnapshot snapshot = working();
    snapshot.activities.emplace_back().answer = SenseAnswer{QStringLiteral("true"), true, Seconds(15.0), Seconds(20.0)};
    auto paths = *snapshot.paths;
    paths.push_back(root + "/S:0"); // the goal, which stands first
    snapshot.paths = std::make_shared<const std::vector<std::string>>(paths);
    panel_->setSnapshot(snapshot);
    QTRY_COMPARE(taken_->count(), 2);
    QSignalSpy asked(&panel_->timeBar(), &PlanTimeBar::timeWanted);
    QListWidget* reasons = list("Reasons");
    const QPoint at = reasonAt("Bumped");
    QTest::mouseClick(reasons->viewport(), Qt::LeftButton, {}, at);
    const PlanNodeId bumped = panel_->view().selected();
    panel_->view().selectPath(root); // as if the click had chosen a part with fewer reasons
    QVERIFY(!reasons->itemAt(at));
    QTest::mouseDClick(reasons->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseRelease(reasons->viewport(), Qt::LeftButton, {}, at);
    QCOMPARE(asked.size(), 1);
    QCOMPARE(asked[0][0].value<Seconds>(), Seconds(12.0));
    QVERIFY(bumped.valid() && panel_->view().selected() == panel_->view().tree().find(root));
}

void tst_PlanPanel::aReasonWithoutATimeLeadsToNone() {
    panel_->view().selectPath(root + "/DE:2");
    QSignalSpy asked(&panel_->timeBar(), &PlanTimeBar::timeWanted);
    QListWidget* reasons = list("Reasons");
    const QPoint at = reasonAt("has priority over rest");
    QTest::mouseClick(reasons->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(reasons->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseRelease(reasons->viewport(), Qt::LeftButton, {}, at);
    QCOMPARE(panel_->view().selected(), panel_->view().tree().find(root + "/DE:1"));
    QVERIFY(asked.isEmpty());
}

void tst_PlanPanel::aChosenSenseIsExplainedOnce() {
    panel_->view().selectPath(root + "/DE:0/S:0");
    QCOMPARE(list("Reasons")->findItems(QStringLiteral("Bumped"), Qt::MatchContains).size(), 1);
}

void tst_PlanPanel::listsOfALowPanelStandBehindTabs() {
    PlanSnapshot snapshot = working();
    snapshot.board = {{QStringLiteral("lane"), QStringLiteral("1"), QStringLiteral("1 at 3.0 s")}};
    panel_->setSnapshot(snapshot);
    const auto seen = [this] {
        QStringList names;
        for (const char* name : {"Running now", "Reasons", "Blackboard", "Breakpoints"})
            if (list(name)->isVisible())
                names << QLatin1String(name);
        return names.join(u' ');
    };
    auto* tabs = panel_->findChild<QTabBar*>();
    QCOMPARE(seen(), QStringLiteral("Running now Reasons Blackboard"));
    QVERIFY(!tabs->isVisible());
    panel_->resize(1200, 240);
    QTRY_COMPARE(seen(), QStringLiteral("Running now"));
    QVERIFY(tabs->isVisible());
    QCOMPARE(tabs->count(), 3);
    QTRY_VERIFY(list("Running now")->height() > 3 * list("Running now")->sizeHintForRow(0));
    tabs->setCurrentIndex(2);
    QCOMPARE(seen(), QStringLiteral("Blackboard"));
    panel_->setBreakpoints({{1, QStringLiteral("go, before"), {}, root, true}});
    QCOMPARE(tabs->count(), 4);
    QCOMPARE(seen(), QStringLiteral("Blackboard"));
    panel_->view().selectPath(root + "/DE:0"); // why does it run, or not?
    QCOMPARE(seen(), QStringLiteral("Reasons"));
    QVERIFY(tabs->isVisible());
    panel_->resize(1200, 800);
    QTRY_COMPARE(seen(), QStringLiteral("Running now Reasons Blackboard Breakpoints"));
    QVERIFY(!tabs->isVisible());
}

void tst_PlanPanel::nothingSelectedListsWhatPreventsTheDrives() {
    QListWidget* reasons = list("Reasons");
    QStringList texts;
    for (int i = 0; i < reasons->count(); ++i)
        texts << reasons->item(i)->text();
    QCOMPARE(texts, QStringList({QStringLiteral("safety: Bumped – no, it is false, for 8.0 s"),
                                 QStringLiteral("work is running now and has priority over rest")}));
    panel_->view().selectPath(root + "/DE:1"); // it runs
    QVERIFY(reasons->findItems(QStringLiteral("safety"), Qt::MatchContains).isEmpty());
}

void tst_PlanPanel::nothingToListSaysWhatToDo() {
    panel_->setPlan(planOf("((DC lookout (drives ((stay Hover)))))")); // nothing is known of it
    QVERIFY(list("Reasons")->item(0)->text().contains(QStringLiteral("Select a part")));
    QTest::mouseClick(list("Reasons")->viewport(), Qt::LeftButton, {}, QPoint(20, 10));
    QCOMPARE(panel_->view().selected(), PlanNodeId{});
    panel_->clear();
    QCOMPARE(list("Running now")->count(), 0);
    QVERIFY(!list("Reasons")->isVisible()); // the sheet of the view says all there is to say
}

void tst_PlanPanel::searchCountsAndSteps() {
    auto* line = panel_->findChild<QLineEdit*>();
    QVERIFY(!button(QStringLiteral("Next match"))->isEnabled());
    QTest::keyClicks(line, QStringLiteral("distance"));
    const auto says = [&](const char* words) {
        for (const QLabel* label : panel_->findChildren<QLabel*>())
            if (label->isVisible() && label->text() == QLatin1String(words))
                return true;
        return false;
    };
    QVERIFY(says("1 of 3"));
    button(QStringLiteral("Next match"))->click();
    QVERIFY(says("2 of 3"));
    button(QStringLiteral("Previous match"))->click();
    QVERIFY(says("1 of 3"));
    QTest::keyClicks(line, QStringLiteral("zebra"));
    QVERIFY(says("none"));
}

void tst_PlanPanel::returnStepsAndEscapeGoesBack() {
    panel_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(panel_.get()));
    auto* line = panel_->findChild<QLineEdit*>();
    QTest::keyClick(&panel_->view(), Qt::Key_F, Qt::ControlModifier);
    QVERIFY(line->hasFocus());
    QTest::keyClicks(line, QStringLiteral("distance"));
    const PlanNodeId first = panel_->view().selected();
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(panel_->view().selected() > first);
    QTest::keyClick(line, Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(panel_->view().selected(), first);
    QTest::keyClick(line, Qt::Key_Escape);
    QVERIFY(line->text().isEmpty() && panel_->view().hasFocus());
}

void tst_PlanPanel::itsKeysAreItsOwnInAWindowThatHasThemToo() {
    panel_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(panel_.get()));
    QShortcut of_window(QKeySequence::Find, panel_.get());
    panel_->view().setFocus();
    QTest::keyClick(panel_->windowHandle(), Qt::Key_F, Qt::ControlModifier);
    QVERIFY(panel_->findChild<QLineEdit*>()->hasFocus());
}

void tst_PlanPanel::sharedPartsAreSwitched() {
    const int once = panel_->view().tree().size();
    auto* shared = button(QStringLiteral("shared parts in full"));
    shared->click();
    QVERIFY(panel_->view().tree().size() > once);
    shared->click();
    QCOMPARE(panel_->view().tree().size(), once);
}

void tst_PlanPanel::buttonsFoldAndUnfold() {
    PlanView& view = panel_->view();
    const PlanNodeId grab = view.tree().find(root + "/DE:1/A:0/C:0/CE:0");
    button(QStringLiteral("Folds everything"))->click();
    QVERIFY(!view.layout().shown(grab));
    button(QStringLiteral("Unfolds everything"))->click();
    QVERIFY(view.layout().shown(grab));
    button(QStringLiteral("Unfolds what is running"))->click();
    QVERIFY(!view.layout().shown(grab));
}

void tst_PlanPanel::textAndDrawingGoTogether() {
    auto* shown = button(QStringLiteral("text beside"));
    QVERIFY(!shown->isEnabled());
    panel_->setPlanText(courier_plan, {});
    QVERIFY(!panel_->textEdit().isVisible());
    QTest::keyClick(&panel_->view(), Qt::Key_Home, Qt::NoModifier);
    QTest::keyClick(&panel_->view(), Qt::Key_Return);
    QVERIFY(panel_->textEdit().isVisible() && shown->isChecked());
    panel_->view().selectPath(root + "/DE:1");
    QCOMPARE(panel_->textEdit().textCursor().blockNumber() + 1, 14);
    QTextCursor cursor(panel_->textEdit().document()->findBlockByNumber(4));
    panel_->textEdit().setTextCursor(cursor);
    QTest::keyClick(&panel_->textEdit(), Qt::Key_End);
    QCOMPARE(panel_->view().tree()[panel_->view().selected()].name, QStringLiteral("CloseGripper"));
    QCOMPARE(panel_->textEdit().textCursor().blockNumber() + 1, 5);
    panel_->clear();
    QVERIFY(!panel_->textEdit().isVisible() && !shown->isEnabled());
}

void tst_PlanPanel::errorsOpenTheText() {
    const std::string_view text = "((DC d (drives ((e Act)))) (AP x ()))";
    const auto reading = posh::readPlan(text);
    panel_->setPlan(reading.plan);
    panel_->setPlanText(text, reading.findings);
    QVERIFY(panel_->textEdit().isVisible());
    panel_->textEdit().nextFinding();
    const auto labels = panel_->findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisible() && label->text().contains(QStringLiteral("E218"));
    }));
}

void tst_PlanPanel::narrowPanelStacks() {
    auto* reasons = list("Reasons");
    QVERIFY(reasons->mapTo(panel_.get(), QPoint()).x() > panel_->view().mapTo(panel_.get(), QPoint()).x() + 400);
    panel_->resize(320, 700);
    QVERIFY(reasons->mapTo(panel_.get(), QPoint()).y() > panel_->view().mapTo(panel_.get(), QPoint()).y() + 200);
    QVERIFY(panel_->width() <= 320);
}

void tst_PlanPanel::buttonsHaveNames() {
    for (const QAbstractButton* each : panel_->findChildren<QToolButton*>())
        if (each->parent() == panel_.get())
            QVERIFY(!each->accessibleName().isEmpty() && each->height() >= minimum_target);
}

void tst_PlanPanel::newsKeepsTheChosenRow() {
    QListWidget* running = list("Running now");
    running->setCurrentRow(1);
    panel_->setSnapshot(working());
    QTRY_COMPARE(taken_->count(), 2);
    QCOMPARE(running->currentRow(), 1);
}

USAR_TEST(tst_PlanPanel)

} // namespace tst_plan_panel

#include "tst_plan_panel.moc"
