#include <algorithm>
#include <array>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "tests/suite/suite.h"
#include "widgets/panels/behavior_panel.h"
#include "widgets/panels/parameter_form.h"

namespace tst_behavior_panel {

using namespace usar;
using namespace usar::widgets;

namespace {

agent::BehaviorDescription behavior(const std::string& id) {
    agent::BehaviorDescription made;
    made.id = id;
    made.name = id;
    made.help = "What " + id + " does.";
    made.parameters = {{"altitude_m", "Altitude", "", "m", 6.0, 2.0, 40.0, "", {}}};
    return made;
}

} // namespace

class tst_BehaviorPanel : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void sameChoiceIsNotToldAgain();
    void anotherChoiceIsTold();
    void parametersSurviveSelectingARobot();
    void listIsLockedWhileRunning();
    void clicksLeaveTheFocusAlone();
    void startedByKeysTheFocusStaysWithTheButtons();
    void buttonsTriggerTheirActions();
    void buttonsFollowTheirActions();
    void buttonsWaitForTheirActions();
    void tooltipsNameTheShortcutsOfTheActions();
    void pauseShowsWhatTheRobotDoes();
    void aPlanIsChosenWhereOneDecides();
    void anAreaIsAskedForWhereOneIsNeeded();
    void whatIsToldAnewOfTheChosenOneIsShown();
    void helpGoesBeforeFieldsAreSqueezed();

private:
    QPushButton* button(const QString& text) const;
    /// Enables the actions that fit the state, as their owner does, and shows it.
    void show(RunState state);

    std::unique_ptr<QWidget> window_;
    QLineEdit* elsewhere_ = nullptr;
    ParameterForm* form_ = nullptr;
    BehaviorPanel* panel_ = nullptr;
    std::array<QAction*, 4> actions_{}; ///< start, pause, land, stop
};

void tst_BehaviorPanel::init() {
    window_ = std::make_unique<QWidget>();
    auto* column = new QVBoxLayout(window_.get());
    column->addWidget(elsewhere_ = new QLineEdit);
    form_ = new ParameterForm;
    column->addWidget(panel_ = new BehaviorPanel(form_));
    for (QAction*& action : actions_)
        action = new QAction(panel_);
    panel_->setActions(actions_[0], actions_[1], actions_[2], actions_[3]);
    window_->show();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
}

void tst_BehaviorPanel::cleanup() {
    window_.reset();
}

QPushButton* tst_BehaviorPanel::button(const QString& text) const {
    for (auto* each : panel_->findChildren<QPushButton*>())
        if (each->text() == text)
            return each;
    return nullptr;
}

void tst_BehaviorPanel::show(RunState state) {
    actions_[0]->setEnabled(state == RunState::Ready);
    for (QAction* action : {actions_[1], actions_[2], actions_[3]})
        action->setEnabled(state == RunState::Running || state == RunState::Paused);
    panel_->setRunState(state, QStringLiteral("R1"));
}

void tst_BehaviorPanel::sameChoiceIsNotToldAgain() {
    panel_->setBehaviors({behavior("a"), behavior("b")});
    panel_->chooseBehavior("b");
    QSignalSpy chosen(panel_, &BehaviorPanel::behaviorChosen);
    panel_->setBehaviors({behavior("b"), behavior("c")});
    QCOMPARE(panel_->behaviorId(), "b");
    QCOMPARE(chosen.count(), 0);
}

void tst_BehaviorPanel::anotherChoiceIsTold() {
    QSignalSpy chosen(panel_, &BehaviorPanel::behaviorChosen);
    panel_->setBehaviors({behavior("a")});
    panel_->setBehaviors({behavior("b")});
    panel_->setBehaviors({});
    QCOMPARE(chosen.count(), 3);
    QCOMPARE(chosen[1][0].toString(), QStringLiteral("b"));
    QCOMPARE(chosen[2][0].toString(), QString());
}

void tst_BehaviorPanel::parametersSurviveSelectingARobot() {
    const std::vector<agent::BehaviorDescription> known = {behavior("a"), behavior("b")};
    connect(panel_, &BehaviorPanel::behaviorChosen, form_, [&] { form_->setSpecs(known[0].parameters); });
    panel_->setBehaviors(known);
    form_->setValues({{"altitude_m", 9.0}});
    panel_->setBehaviors(known);
    QCOMPARE(std::get<double>(form_->values().at("altitude_m")), 9.0);
}

void tst_BehaviorPanel::listIsLockedWhileRunning() {
    panel_->setRunState(RunState::Running, QStringLiteral("R1"));
    panel_->setBehaviors({behavior("a")});
    QVERIFY(!panel_->findChild<QComboBox*>()->isEnabled());
    panel_->setRunState(RunState::Ready, QStringLiteral("R1"));
    QVERIFY(panel_->findChild<QComboBox*>()->isEnabled());
}

void tst_BehaviorPanel::clicksLeaveTheFocusAlone() {
    show(RunState::Ready);
    connect(actions_[0], &QAction::triggered, panel_, [this] { show(RunState::Running); });
    elsewhere_->setFocus();
    QTest::mouseClick(button(QStringLiteral("Start")), Qt::LeftButton);
    QCoreApplication::processEvents();
    QVERIFY(!button(QStringLiteral("Start"))->isEnabled());
    QVERIFY(elsewhere_->hasFocus());
}

void tst_BehaviorPanel::startedByKeysTheFocusStaysWithTheButtons() {
    show(RunState::Ready);
    connect(actions_[0], &QAction::triggered, panel_, [this] { show(RunState::Running); });
    button(QStringLiteral("Start"))->setFocus();
    QTest::keyClick(button(QStringLiteral("Start")), Qt::Key_Space);
    QTRY_VERIFY(!button(QStringLiteral("Start"))->isEnabled());
    QVERIFY(button(QStringLiteral("Pause"))->hasFocus());
}

void tst_BehaviorPanel::buttonsTriggerTheirActions() {
    const std::pair<QString, QAction*> pairs[] = {{QStringLiteral("Start"), actions_[0]},
                                                  {QStringLiteral("Pause"), actions_[1]},
                                                  {QStringLiteral("Land now"), actions_[2]},
                                                  {QStringLiteral("Stop"), actions_[3]}};
    for (const auto& [text, action] : pairs) {
        QSignalSpy triggered(action, &QAction::triggered);
        QTest::mouseClick(button(text), Qt::LeftButton);
        QCOMPARE(triggered.count(), 1);
    }
}

void tst_BehaviorPanel::buttonsFollowTheirActions() {
    actions_[0]->setEnabled(false);
    panel_->setRunState(RunState::Ready, QStringLiteral("R1"));
    QVERIFY(!button(QStringLiteral("Start"))->isEnabled());
    actions_[0]->setEnabled(true);
    QVERIFY(button(QStringLiteral("Start"))->isEnabled());
    panel_->setRunState(RunState::Running, QStringLiteral("R1"));
    QVERIFY(button(QStringLiteral("Stop"))->isEnabled());
}

void tst_BehaviorPanel::buttonsWaitForTheirActions() {
    BehaviorPanel bare(new ParameterForm);
    bare.setRunState(RunState::Ready, QStringLiteral("R1"));
    const auto buttons = bare.findChildren<QPushButton*>();
    const auto start = std::ranges::find(buttons, QStringLiteral("Start"), &QPushButton::text);
    QVERIFY(start != buttons.end());
    QVERIFY(!(*start)->isEnabled());
}

void tst_BehaviorPanel::tooltipsNameTheShortcutsOfTheActions() {
    QAction& pause = *actions_[1];
    pause.setShortcut(QKeySequence(Qt::Key_P));
    QVERIFY(button(QStringLiteral("Pause"))->toolTip().endsWith(QStringLiteral("(P)")));
    pause.setShortcut(QKeySequence(Qt::Key_F9));
    QVERIFY(button(QStringLiteral("Pause"))->toolTip().endsWith(QStringLiteral("(F9)")));
    QVERIFY(!button(QStringLiteral("Stop"))->toolTip().contains(u'('));
}

void tst_BehaviorPanel::pauseShowsWhatTheRobotDoes() {
    panel_->setRunState(RunState::Running, QStringLiteral("R1"));
    QTest::mouseClick(button(QStringLiteral("Pause")), Qt::LeftButton);
    QVERIFY(!button(QStringLiteral("Pause"))->isChecked());
    panel_->setRunState(RunState::Paused, QStringLiteral("R1"));
    QVERIFY(button(QStringLiteral("Resume"))->isChecked());
}

void tst_BehaviorPanel::aPlanIsChosenWhereOneDecides() {
    agent::BehaviorDescription planned = behavior("rover/posh");
    planned.plan_name = "rover.lap";
    panel_->setBehaviors({behavior("rover/cpp"), planned});
    QVERIFY(!panel_->plan().isVisible());
    panel_->chooseBehavior("rover/posh");
    QVERIFY(panel_->plan().isVisible());
    QVERIFY(panel_->plan().path().isEmpty()); // the robot's own
    panel_->plan().choose("/data/own.lap");
    QCOMPARE(panel_->plan().path(), QString("/data/own.lap"));

    auto* const box = panel_->plan().findChild<QComboBox*>();
    QSignalSpy chosen(&panel_->plan(), &PlanChoice::chosen);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Up);
    QCOMPARE(chosen.size(), 1);
    QVERIFY(panel_->plan().path().isEmpty());

    panel_->chooseBehavior("rover/cpp");
    QVERIFY(panel_->plan().path().isEmpty());
    panel_->chooseBehavior("rover/posh");
    QCOMPARE(box->count(), 2); // it is still in the list
    QCOMPARE(chosen.size(), 1);
}

void tst_BehaviorPanel::anAreaIsAskedForWhereOneIsNeeded() {
    agent::BehaviorDescription survey = behavior("air/survey");
    survey.needs_area = true;
    panel_->setBehaviors({survey, behavior("rover/cpp")});
    const auto* const form = panel_->findChild<AreaForm*>();
    QVERIFY(form->isVisible());
    panel_->chooseBehavior("rover/cpp");
    QVERIFY(!form->isVisible());
    QVERIFY(!panel_->needsArea());
}

void tst_BehaviorPanel::whatIsToldAnewOfTheChosenOneIsShown() {
    agent::BehaviorDescription survey = behavior("air/survey");
    panel_->setBehaviors({survey});
    QVERIFY(!panel_->findChild<AreaForm*>()->isVisible());
    survey.needs_area = true;
    panel_->setBehaviors({survey});
    QVERIFY(panel_->findChild<AreaForm*>()->isVisible());
}

void tst_BehaviorPanel::helpGoesBeforeFieldsAreSqueezed() {
    agent::BehaviorDescription survey = behavior("air/survey");
    survey.needs_area = true;
    survey.help = QString("Says at length what it does. ").repeated(12).trimmed().toStdString();
    const auto help = [&] {
        const auto labels = panel_->findChildren<QLabel*>();
        return *std::ranges::find_if(labels,
                                     [](const QLabel* one) { return one->text().startsWith("Says at length"); });
    };
    window_->resize(300, 900);
    panel_->setBehaviors({survey});
    QTRY_VERIFY(help()->isVisible());
    window_->resize(300, 480);
    QTRY_VERIFY(!help()->isVisible());
    for (const QDoubleSpinBox* field : panel_->findChildren<QDoubleSpinBox*>())
        QVERIFY2(field->height() >= field->minimumHeight(), qPrintable(field->accessibleName()));
    QVERIFY(panel_->findChild<QComboBox*>()->toolTip().contains("Says at length"));
    window_->resize(300, 900);
    QTRY_VERIFY(help()->isVisible());
}

USAR_TEST(tst_BehaviorPanel)

} // namespace tst_behavior_panel

#include "tst_behavior_panel.moc"
