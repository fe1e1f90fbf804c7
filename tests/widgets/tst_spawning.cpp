#include <algorithm>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyleOptionComboBox>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/spawn_card.h"

namespace tst_spawning {

using namespace usar;
using namespace usar::widgets;

namespace {

std::vector<agent::RobotDescription> robots() {
    agent::RobotDescription air{"USARBot.AirRobot", "AirRobot", {}, {}};
    air.behaviors.push_back({"airrobot/cpp", "Terrain survey (C++)", "Scans.", true, {}});
    air.behaviors.push_back({"airrobot/posh", "Terrain survey (POSH)", "Scans.", true, {}});
    const agent::RobotDescription ground{"USARBot.P2DX", "P2DX", {}, {}};
    agent::RobotDescription diver{"USARBot.Submarine", "Submarine", {}, {}};
    diver.behaviors.push_back({"diver/cpp", "Dives along the bottom of the sea (C++)", "Dives.", true, {}});
    return {air, ground, diver};
}

} // namespace

class tst_Spawning : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void returnSpawnsWhatIsChosen();
    void theBehaviorThatIsSetUpIsChosen();
    void behaviorsFollowTheRobot();
    void refusesNamesThatTheWireCannotCarry();
    void theGreatestNumberIsSaidBeforeAndWhenItIsReached();
    void escapeCloses();
    void pressOnTheMapClosesAndReachesIt();
    void doubleClickOnTheMapClosesAndLeavesTheFocusThere();
    void closingGivesTheFocusToTheMap_data();
    void closingGivesTheFocusToTheMap();
    void staysWithinTheMap();
    void neverCoversThePose();
    void namesOfBehaviorsAreWhole();
    void remembersTheLastChoice();

private:
    std::unique_ptr<QWidget> map_;
    SpawnCard* card_ = nullptr;
};

void tst_Spawning::init() {
    map_ = std::make_unique<QWidget>();
    map_->resize(600, 400);
    map_->setFocusPolicy(Qt::StrongFocus);
    card_ = new SpawnCard(map_.get());
    card_->setRobots(robots());
    map_->show();
    QVERIFY(QTest::qWaitForWindowActive(map_.get()));
    card_->openFor(1, QStringLiteral("HillTop"), QStringLiteral("R3"), map_->mapToGlobal(QPoint(100, 100)));
}

void tst_Spawning::cleanup() {
    map_.reset();
}

void tst_Spawning::returnSpawnsWhatIsChosen() {
    QSignalSpy spawned(card_, &SpawnCard::spawnRequested);
    QTest::keyClick(card_, Qt::Key_Return);
    QCOMPARE(spawned.count(), 1);
    QCOMPARE(spawned[0][0].value<SpawnChoice>(), (SpawnChoice{1, QStringLiteral("USARBot.AirRobot"),
                                                              QStringLiteral("R3"), QStringLiteral("airrobot/cpp")}));
    QVERIFY(card_->isHidden());
}

void tst_Spawning::theBehaviorThatIsSetUpIsChosen() {
    card_->preferBehavior("airrobot/posh");
    QCOMPARE(card_->choice().behavior_id, QString("airrobot/posh"));
    card_->preferBehavior("p2dx/cpp"); // of another robot
    QCOMPARE(card_->choice().behavior_id, QString("airrobot/posh"));
}

void tst_Spawning::behaviorsFollowTheRobot() {
    const auto combos = card_->findChildren<QComboBox*>();
    QCOMPARE(combos[1]->count(), 3);
    QTest::keyClick(combos[0], Qt::Key_Down);
    QCOMPARE(card_->choice().class_name, QStringLiteral("USARBot.P2DX"));
    QCOMPARE(combos[1]->count(), 1);
    QCOMPARE(card_->choice().behavior_id, QString());
}

void tst_Spawning::refusesNamesThatTheWireCannotCarry() {
    QSignalSpy spawned(card_, &SpawnCard::spawnRequested);
    auto* name = card_->findChild<QLineEdit*>();
    name->clear();
    QVERIFY(!card_->findChild<QPushButton*>()->isEnabled());
    QTest::keyClick(card_, Qt::Key_Return);
    QCOMPARE(spawned.count(), 0);
    QTest::keyClicks(name, QStringLiteral("my {robot}"));
    QCOMPARE(name->text(), QStringLiteral("myrobot"));
}

void tst_Spawning::theGreatestNumberIsSaidBeforeAndWhenItIsReached() {
    const auto says = [this](const QString& text) {
        return std::ranges::any_of(card_->findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text() == text; });
    };
    const auto* const button = card_->findChild<QPushButton*>();
    QSignalSpy spawned(card_, &SpawnCard::spawnRequested);
    card_->setRoom(8, 9);
    QVERIFY(says(QStringLiteral("Robot 9 of 9")));
    QVERIFY(button->isEnabled());
    card_->setRoom(9, 9);
    QCOMPARE(button->text(), QStringLiteral("Limit reached: 9 robots"));
    QVERIFY(!button->isEnabled());
    card_->openFor(1, QStringLiteral("HillTop"), QStringLiteral("R10"), map_->mapToGlobal(QPoint(100, 100)));
    QVERIFY2(!button->isEnabled(), "another name does not help");
    QTest::keyClick(card_, Qt::Key_Return);
    QCOMPARE(spawned.count(), 0);
    QTest::keyClick(map_->window()->focusWidget(), Qt::Key_Escape);
    QVERIFY(card_->isHidden());
    QVERIFY(map_->hasFocus());
    card_->setRoom(4, 9);
    QCOMPARE(button->text(), QStringLiteral("Spawn"));
    QVERIFY(button->isEnabled());
}

void tst_Spawning::escapeCloses() {
    QTest::keyClick(card_, Qt::Key_Escape);
    QVERIFY(card_->isHidden());
}

void tst_Spawning::pressOnTheMapClosesAndReachesIt() {
    QVERIFY(card_->isVisible());
    QTest::mousePress(map_.get(), Qt::LeftButton, {}, QPoint(20, 20));
    QVERIFY(card_->isHidden());
}

// The first click of a double-click opens the card and focuses its Spawn button: Space would spawn a second robot.
void tst_Spawning::doubleClickOnTheMapClosesAndLeavesTheFocusThere() {
    QSignalSpy spawned(card_, &SpawnCard::spawnRequested);
    QTest::mouseEvent(QTest::MouseDClick, map_.get(), Qt::LeftButton, {}, QPoint(20, 20));
    QVERIFY(card_->isHidden());
    QVERIFY(map_->hasFocus());
    QTest::keyClick(map_->window()->focusWidget(), Qt::Key_Space);
    QCOMPARE(spawned.count(), 0);
}

void tst_Spawning::closingGivesTheFocusToTheMap_data() {
    QTest::addColumn<int>("key");
    QTest::newRow("by Escape") << int(Qt::Key_Escape);
    QTest::newRow("by spawning") << int(Qt::Key_Return);
}

void tst_Spawning::closingGivesTheFocusToTheMap() {
    QFETCH(int, key);
    QVERIFY(card_->isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key(key));
    QVERIFY(card_->isHidden());
    QVERIFY(map_->hasFocus());
}

void tst_Spawning::neverCoversThePose() {
    const QPoint pose(560, 360);
    card_->openFor(0, QStringLiteral("Edge"), QStringLiteral("R1"), map_->mapToGlobal(pose + QPoint(24, 24)));
    QVERIFY(map_->rect().contains(card_->geometry()));
    QVERIFY(!card_->geometry().contains(pose));
}

void tst_Spawning::staysWithinTheMap() {
    card_->openFor(0, QStringLiteral("Edge"), QStringLiteral("R1"), map_->mapToGlobal(QPoint(595, 395)));
    QVERIFY(map_->rect().contains(card_->geometry()));
}

/// Also those of a class that is chosen after the card was opened, at the edge of the map.
void tst_Spawning::namesOfBehaviorsAreWhole() {
    card_->openFor(1, QStringLiteral("HillTop"), QStringLiteral("R3"), map_->mapToGlobal(QPoint(380, 100)));
    const QComboBox* const behavior = card_->findChildren<QComboBox*>()[1];
    for (const char* const class_name : {"USARBot.AirRobot", "USARBot.Submarine", "USARBot.P2DX"}) {
        card_->chooseClass(class_name);
        const int text_px = behavior->fontMetrics().horizontalAdvance(behavior->currentText());
        const auto width_px = [&] {
            QStyleOptionComboBox option;
            option.initFrom(behavior);
            return behavior->style()
                ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, behavior)
                .width();
        };
        QTRY_VERIFY2(
            width_px() >= text_px,
            qPrintable(QString("%1 has %2 of %3 px").arg(behavior->currentText()).arg(width_px()).arg(text_px)));
        QVERIFY(map_->rect().contains(card_->geometry()));
    }
}

void tst_Spawning::remembersTheLastChoice() {
    QTest::keyClick(card_->findChildren<QComboBox*>()[1], Qt::Key_Down);
    QTest::keyClick(card_, Qt::Key_Return);
    const SpawnChoice again = card_->lastChoice(0, QStringLiteral("R4"));
    QCOMPARE(again, (SpawnChoice{0, QStringLiteral("USARBot.AirRobot"), QStringLiteral("R4"),
                                 QStringLiteral("airrobot/posh")}));
}

USAR_TEST(tst_Spawning)

} // namespace tst_spawning

#include "tst_spawning.moc"
