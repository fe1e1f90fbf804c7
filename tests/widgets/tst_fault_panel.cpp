#include <algorithm>

#include <QAction>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/panels/fault_panel.h"
#include "widgets/panels/quantity_box.h"
#include "widgets/style/empty_state.h"

namespace tst_fault_panel {

using namespace usar::widgets;

namespace {

const std::vector<FaultKindInfo> kinds{
    {"sensor_bias", "a sensor reads too much", true, true, {{"x", "m", -10.0, 10.0, 0.0, "added"}}},
    {"wind",
     "moving air",
     false,
     false,
     {{"speed", "m/s", 0.0, 60.0, 3.0, "mean"}, {"toward_deg", "deg", -360, 360, 0, ""}}},
    {"link_cut", "the server hangs up", true, false, {}}};

} // namespace

class tst_FaultPanel : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup() { panel_.reset(); }

    void writesWhatIsSetUp();
    void aNumberAtItsUsualValueIsLeftOut();
    void aTypedSensorStaysWhenOthersBecomeKnown();
    void onlyWhatIsNotOverCanBeEnded();
    void buttonsFollowTheirActions();
    void buttonsAreSeenInALowDock();
    void saysWhoCouldMakeFaultsWhereNobodyCan();

private:
    /// By its accessible name; what the kind does not have is not visible.
    template <class Field>
    Field* field(const QString& name) const {
        for (Field* one : panel_->findChildren<Field*>())
            if (one->accessibleName() == name && one->isVisible())
                return one;
        return nullptr;
    }
    void type(const QString& name, const QString& value) {
        QTRY_VERIFY2(field<QuantityBox>(name), qPrintable(name)); // fields of another kind come with the layout
        auto* box = field<QuantityBox>(name);
        box->selectAll();
        QTest::keyClicks(box, value);
        QTest::keyClick(box, Qt::Key_Return);
    }

    std::unique_ptr<FaultPanel> panel_;
};

void tst_FaultPanel::init() {
    panel_ = std::make_unique<FaultPanel>();
    panel_->setKinds(kinds);
    panel_->setRobots({"R1", "R2"});
    panel_->setSensors({"INS", "Sonar"});
    panel_->setAvailable(true);
    panel_->show();
}

void tst_FaultPanel::writesWhatIsSetUp() {
    QCOMPARE(panel_->text(), "sensor_bias");
    type("x", "0.5");
    type("Begins", "60");
    type("Lasts", "2.5");
    QTest::keyClick(field<QComboBox>("Robot"), Qt::Key_Down);
    QTest::keyClick(field<QComboBox>("Sensor"), Qt::Key_Down);
    QCOMPARE(panel_->text(), "sensor_bias robot=R1 sensor=INS x=0.5 from=60 for=2.5");
    QTest::keyClick(field<QComboBox>("Kind of fault"), Qt::Key_Down);
    QVERIFY(!field<QComboBox>("Robot")); // the wind is for all
    QVERIFY(!field<QComboBox>("Sensor"));
    type("Toward", "90");
    QCOMPARE(panel_->text(), "wind toward_deg=90 from=60 for=2.5");
    QTest::keyClick(field<QComboBox>("Kind of fault"), Qt::Key_Down);
    QCOMPARE(panel_->text(), "link_cut robot=R1 from=60 for=2.5");
}

void tst_FaultPanel::aNumberAtItsUsualValueIsLeftOut() {
    QTest::keyClick(field<QComboBox>("Kind of fault"), Qt::Key_Down);
    type("Speed", "7");
    QCOMPARE(panel_->text(), "wind speed=7");
    type("Speed", "3");
    QCOMPARE(panel_->text(), "wind");
    type("Speed", "600"); // pulled to its bound
    QCOMPARE(panel_->text(), "wind speed=60");
}

void tst_FaultPanel::aTypedSensorStaysWhenOthersBecomeKnown() {
    auto* sensor = field<QComboBox>("Sensor");
    sensor->lineEdit()->selectAll();
    QTest::keyClicks(sensor, "F4");
    QCOMPARE(panel_->text(), "sensor_bias sensor=F4");
    panel_->setSensors({"GPS", "INS"});
    QCOMPARE(panel_->text(), "sensor_bias sensor=F4");
}

void tst_FaultPanel::onlyWhatIsNotOverCanBeEnded() {
    panel_->setFaults({{1, "wind", FaultState::Over, {}}, {2, "link_cut", FaultState::Active, "From 3 s"}});
    QCOMPARE(panel_->endable(), 0); // nothing is selected
    QVERIFY(panel_->anyToEnd());
    auto* list = panel_->findChild<QTreeWidget*>();
    const auto click = [&](int row) {
        const QRect at = list->visualItemRect(list->topLevelItem(row));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at.center());
    };
    click(0); // the newest is at the top
    QCOMPARE(panel_->endable(), 2);
    panel_->setFaults(
        {{1, "wind", FaultState::Over, {}}, {2, "link_cut", FaultState::Active, {}}, {3, "wind", {}, {}}});
    QCOMPARE(panel_->endable(), 2); // stays selected
    click(2);
    QCOMPARE(panel_->endable(), 0);
    panel_->setFaults({{1, "wind", FaultState::Over, {}}});
    QVERIFY(!panel_->anyToEnd());
}

void tst_FaultPanel::buttonsFollowTheirActions() {
    QAction inject;
    QAction end;
    end.setEnabled(false);
    panel_->setActions(&inject, &end);
    QSignalSpy injected(&inject, &QAction::triggered);
    for (QPushButton* button : panel_->findChildren<QPushButton*>())
        if (button->text() == "Inject fault")
            QTest::mouseClick(button, Qt::LeftButton);
        else if (button->text() == "End fault")
            QVERIFY(!button->isEnabled());
    QCOMPARE(injected.size(), 1);
}

void tst_FaultPanel::buttonsAreSeenInALowDock() {
    panel_->resize(280, 200);
    QTRY_COMPARE(panel_->size(), QSize(280, 200));
    const auto buttons = panel_->findChildren<QPushButton*>();
    QVERIFY(std::ranges::count_if(buttons, &QWidget::isVisible) == 2);
    for (const QPushButton* button : buttons)
        if (button->isVisible())
            QTRY_COMPARE(button->visibleRegion().boundingRect(), button->rect());
}

void tst_FaultPanel::saysWhoCouldMakeFaultsWhereNobodyCan() {
    QVERIFY(!panel_->emptyState()->isVisible());
    panel_->setAvailable(false);
    QVERIFY(panel_->emptyState()->isVisible());
    QVERIFY(!field<QComboBox>("Kind of fault"));
}

USAR_TEST(tst_FaultPanel)

} // namespace tst_fault_panel

#include "tst_fault_panel.moc"
