#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/layers_panel.h"

namespace tst_height_controls {

using namespace usar;
using namespace usar::widgets;

namespace {

/// The child with this accessible name.
template <class Widget>
Widget* child(const QWidget& of, const QString& name) {
    for (Widget* const one : of.findChildren<Widget*>())
        if (one->accessibleName() == name)
            return one;
    return nullptr;
}

} // namespace

class tst_HeightControls : public QObject {
    Q_OBJECT
private slots:
    void heightsCanBeGrayAndKeepTheirRange();
    void extremeHeightsAreLeftOutOrTheRangeIsFixed();
    void theScanOfOneRobotCanBeChosen();
    void aStateWithoutRobotsLeavesTheChoice();
};

void tst_HeightControls::extremeHeightsAreLeftOutOrTheRangeIsFixed() {
    LayersPanel panel;
    HeightControls& controls = *panel.heightControls();
    QSignalSpy changed(&controls, &HeightControls::lookChanged);
    QSignalSpy edited(&panel, &LayersPanel::edited);
    auto* const trimmed = child<QCheckBox>(panel, QStringLiteral("Range without extreme heights"));
    auto* const fixed = child<QCheckBox>(panel, QStringLiteral("Fixed range of heights"));
    trimmed->click();
    QCOMPARE(changed.last()[0].value<HeightLook>(), (HeightLook{mapping::ColorMap::Color, std::nullopt, true}));
    QCOMPARE(edited.count(), 1);
    LayersPanel after;
    QVERIFY(after.restoreState(panel.saveState()));
    QCOMPARE(after.heightControls()->look(), controls.look());
    controls.setShownRange({0.0f, 5.0f});
    fixed->click(); // Begins with what the map shows, and takes the place of the other choice.
    const HeightLook typed{mapping::ColorMap::Color, mapping::HeightRange{0.0f, 5.0f}, false};
    QCOMPARE(changed.last()[0].value<HeightLook>(), typed);
    QVERIFY(after.restoreState(panel.saveState()));
    QCOMPARE(after.heightControls()->look(), typed);
    trimmed->click();
    QCOMPARE(controls.look(), (HeightLook{mapping::ColorMap::Color, std::nullopt, true}));
    trimmed->click();
    QCOMPARE(controls.look(), HeightLook{});
}

void tst_HeightControls::theScanOfOneRobotCanBeChosen() {
    LayersPanel panel;
    HeightControls& controls = *panel.heightControls();
    panel.show();
    QCOMPARE(controls.scope(), mapping::HeightScope::AllRobots);
    QSignalSpy changed(&controls, &HeightControls::scopeChanged);
    QSignalSpy looks(&controls, &HeightControls::lookChanged);
    QTest::keyClick(child<QComboBox>(panel, QStringLiteral("Robots whose heights are shown")), Qt::Key_Down);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed.last()[0].value<mapping::HeightScope>(), mapping::HeightScope::SelectedRobot);
    LayersPanel after;
    QVERIFY(after.restoreState(panel.saveState()));
    QCOMPARE(after.heightControls()->scope(), mapping::HeightScope::SelectedRobot);
    controls.setScope(mapping::HeightScope::AllRobots);
    QCOMPARE(changed.count(), 2);
    QVERIFY(after.restoreState(panel.saveState()));
    QCOMPARE(after.heightControls()->scope(), mapping::HeightScope::AllRobots);
    QCOMPARE(looks.count(), 0);
}

/// As settings of an earlier version are.
void tst_HeightControls::aStateWithoutRobotsLeavesTheChoice() {
    HeightControls controls;
    controls.setScope(mapping::HeightScope::SelectedRobot);
    controls.restoreState({{"gray", true}, {"robots", "both"}});
    QCOMPARE(controls.scope(), mapping::HeightScope::SelectedRobot);
    QCOMPARE(controls.look().color_map, mapping::ColorMap::Gray);
}

void tst_HeightControls::heightsCanBeGrayAndKeepTheirRange() {
    LayersPanel panel;
    HeightControls& controls = *panel.heightControls();
    panel.show();
    QCOMPARE(controls.look(), HeightLook{});
    QSignalSpy changed(&controls, &HeightControls::lookChanged);
    QTest::mouseClick(child<QCheckBox>(panel, QStringLiteral("Gray heights")), Qt::LeftButton, {}, QPoint(8, 8));
    QCOMPARE(changed.last()[0].value<HeightLook>(), (HeightLook{mapping::ColorMap::Gray, std::nullopt}));
    auto* const lowest = child<QuantityBox>(panel, QStringLiteral("Lowest height"));
    QVERIFY(!lowest->isVisible());
    controls.setShownRange({-1.5f, 18.25f});
    QCOMPARE(changed.count(), 1);
    QTest::mouseClick(child<QCheckBox>(panel, QStringLiteral("Fixed range of heights")), Qt::LeftButton, {},
                      QPoint(8, 8));
    QVERIFY(lowest->isVisible());
    const mapping::HeightRange fixed{-1.5f, 18.25f};
    QCOMPARE(changed.last()[0].value<HeightLook>(), (HeightLook{mapping::ColorMap::Gray, fixed}));
    controls.setShownRange({-3.0f, 30.0f});
    QCOMPARE(controls.look().fixed_range, std::optional(fixed));
    LayersPanel after;
    QVERIFY(after.restoreState(panel.saveState()));
    QCOMPARE(after.heightControls()->look(), controls.look());
    lowest->setValue(20.0); // Above the highest one.
    QCOMPARE(changed.last()[0].value<HeightLook>().fixed_range, std::optional(mapping::HeightRange{18.25f, 20.0f}));
}

USAR_TEST(tst_HeightControls)

} // namespace tst_height_controls

#include "tst_height_controls.moc"
