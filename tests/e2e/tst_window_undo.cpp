// What a person edits in the window is undone and redone there, and layouts are kept under names of one's own.
#include <algorithm>

#include <QComboBox>
#include <QDir>
#include <QImage>
#include <QLineEdit>
#include <QTest>
#include <QUndoView>

#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/panels/layout_dialog.h"
#include "widgets/style/theme.h"
#include "widgets/window/dock_arranger.h"

namespace tst_window_undo {

using namespace usar;

namespace {

const Rectangle area{{-20.0, -15.0}, {20.0, 15.0}};

QString textOf(WindowPage& page, const char* id) {
    return page.window().commands().action(id)->text();
}

/// Drags the middle of the area by this much.
void dragArea(WindowPage& page, const Vec2& by_m) {
    const auto at = [&](const Vec2& point_m) { return page.map().transform().toScreen(point_m).toPoint(); };
    const Vec2 middle_m = (page.map().area()->min_m + page.map().area()->max_m) / 2.0;
    page.window().commands().action("mission.area")->setChecked(false);
    page.window().commands().action("mission.area")->trigger();
    QTest::mousePress(&page.map(), Qt::LeftButton, {}, at(middle_m));
    for (int step = 1; step <= 5; ++step)
        QTest::mouseMove(&page.map(), at(middle_m + by_m * step / 5.0));
    QTest::mouseRelease(&page.map(), Qt::LeftButton, {}, at(middle_m + by_m));
}

widgets::LayoutDialog* dialogOf(WindowPage& page) {
    return page.window().findChild<widgets::LayoutDialog*>();
}

} // namespace

class tst_WindowUndo : public QObject {
    Q_OBJECT
private slots:
    void eachDragOfTheAreaIsUndoneByOneKey();
    void theEditOfAnotherRobotIsShownWhereItIsUndone();
    void aParameterIsUndoneInItsForm();
    void aPresetIsOneEdit();
    void aLayerIsUndone();
    void aPlotIsUndone();
    void plotsThatComeBackAfterTheNextStartAreNoEdit();
    void aLayoutIsUndone();
    void whatWasSentIsInTheListAndIsPassedOver();
    void aLayoutOfOnesOwnComesBackAfterTheNextStart();
    void aDamagedLayoutIsOneNotice();
};

void tst_WindowUndo::eachDragOfTheAreaIsUndoneByOneKey() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(!page.window().commands().action("edit.undo")->isEnabled());
    page.typeArea(area);
    QTRY_VERIFY(page.map().area());
    const Rectangle first = *page.map().area();
    dragArea(page, Vec2(5.0, 0.0));
    const Rectangle second = *page.map().area();
    QVERIFY(second.min_m.x() > first.min_m.x());
    dragArea(page, Vec2(0.0, 5.0));
    QCOMPARE(textOf(page, "edit.undo"), QString("Undo move area"));
    page.pressKey(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(*page.map().area(), second);
    page.pressKey(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(*page.map().area(), first);
    QCOMPARE(page.window().views().behavior->area(), first);
    QCOMPARE(textOf(page, "edit.redo"), QString("Redo move area"));
    page.window().commands().action("edit.redo")->trigger(); // Its key differs between platforms.
    QCOMPARE(*page.map().area(), second);
}

void tst_WindowUndo::theEditOfAnotherRobotIsShownWhereItIsUndone() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.typeArea(area);
    QTRY_VERIFY(page.map().area());
    page.window().control().remove({1});
    QTRY_VERIFY_WITH_TIMEOUT(!page.robot(1), soon_ms);
    const auto& history = page.window().control().history();
    bool said_why = false;
    for (int row = 0; row < page.window().control().history().stack()->count(); ++row)
        said_why = said_why || history.reasonOf(row).contains("gone");
    QVERIFY(said_why);
    QVERIFY(!textOf(page, "edit.undo").contains("area"));
}

void tst_WindowUndo::aParameterIsUndoneInItsForm() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QTRY_VERIFY(!page.window().views().parameters->values().empty());
    const auto before = page.window().views().parameters->values();
    for (const auto& [id, value] : before) // One may be as high as it can be.
        if (std::holds_alternative<double>(value) && page.window().views().parameters->values() == before)
            page.window().views().parameters->setValues({{id, std::get<double>(value) * 1.01}});
    QVERIFY(page.window().views().parameters->values() != before);
    emit page.window().views().parameters->changed(page.window().views().parameters->values());
    QVERIFY(textOf(page, "edit.undo").startsWith("Undo set "));
    page.window().commands().action("edit.undo")->trigger();
    QVERIFY(page.window().views().parameters->values() == before);
}

void tst_WindowUndo::aPresetIsOneEdit() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.typeArea(area);
    widgets::ParameterForm* const form = page.window().views().parameters;
    auto* const list = form->findChild<QComboBox*>("preset");
    QVERIFY(list && list->isVisible());
    QCOMPARE(list->currentText(), QString("Defaults"));
    const auto lanes = [&] { return page.map().content().area.lanes_in_map_m.size(); };
    QTRY_VERIFY(lanes() > 0);
    const std::size_t before = lanes();
    list->setFocus();
    QTest::keyClick(list, Qt::Key_B);
    QCOMPARE(list->currentText(), QString("Balanced"));
    QCOMPARE(std::get<double>(form->values().at("scan_altitude_m")), 0.0); // by the resolution
    QTRY_VERIFY(lanes() < before);
    page.screenshot("preset");
    page.pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(form->modified().empty());
    QCOMPARE(list->currentText(), QString("Defaults"));
    QTRY_COMPARE(lanes(), before);
}

void tst_WindowUndo::aLayerIsUndone() {
    WindowPage page;
    widgets::LayersPanel& layers = *page.window().views().layers;
    const widgets::LayerState before = page.map().layer(widgets::MapLayer::Grid);
    for (QToolButton* eye : layers.findChildren<QToolButton*>())
        if (eye->accessibleName() == "Show " + widgets::layerName(widgets::MapLayer::Grid))
            eye->click();
    QCOMPARE(page.map().layer(widgets::MapLayer::Grid).visible, !before.visible);
    page.window().commands().action("edit.undo")->trigger();
    QCOMPARE(page.map().layer(widgets::MapLayer::Grid).visible, before.visible);
    QCOMPARE(layers.layer(widgets::MapLayer::Grid).visible, before.visible);
}

void tst_WindowUndo::aPlotIsUndone() {
    WindowPage page;
    widgets::PlotView& plots = *page.window().views().plots;
    plots.addSeries("SEN Sonar/F1/range", "m");
    plots.addSeries("SEN Sonar/F2/range", "m");
    QCOMPARE(plots.model().layout().canvases.front().size(), std::size_t(2));
    QCOMPARE(textOf(page, "edit.undo"), QString("Undo plot SEN Sonar/F2/range"));
    page.window().commands().action("edit.undo")->trigger();
    QCOMPARE(plots.model().layout().canvases.front().size(), std::size_t(1));
    QCOMPARE(textOf(page, "edit.undo"), QString("Undo plot SEN Sonar/F1/range"));
    page.window().commands().action("edit.redo")->trigger();
    QCOMPARE(plots.model().layout().canvases.front().size(), std::size_t(2));
    plots.clear();
    QVERIFY(plots.model().empty());
    page.window().commands().action("edit.undo")->trigger();
    QCOMPARE(plots.model().layout().canvases.front().size(), std::size_t(2));
}

void tst_WindowUndo::plotsThatComeBackAfterTheNextStartAreNoEdit() {
    QTemporaryDir settings;
    const WindowSetup setup{.settings_folder = settings.path()};
    {
        WindowPage page(setup);
        page.window().views().plots->addSeries("SEN Sonar/F1/range", "m");
        page.window().close();
    }
    WindowPage page(setup);
    QVERIFY(!page.window().views().plots->model().empty());
    QVERIFY(!page.window().commands().action("edit.undo")->isEnabled());
}

void tst_WindowUndo::aLayoutIsUndone() {
    WindowPage page;
    QDockWidget* const plan = page.window().views().plan_dock;
    QTRY_VERIFY(plan->visibleRegion().isEmpty());
    page.window().commands().action("view.plan")->trigger();
    QTRY_VERIFY(!plan->visibleRegion().isEmpty());
    QCOMPARE(textOf(page, "edit.undo"), QString("Undo show layout plan"));
    page.window().commands().action("edit.undo")->trigger();
    QTRY_VERIFY(plan->visibleRegion().isEmpty());
}

void tst_WindowUndo::whatWasSentIsInTheListAndIsPassedOver() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.typeArea(area);
    QTRY_VERIFY(page.map().area());
    page.window().commands().action("mission.stop_all")->trigger();
    const QUndoView* const list = page.window().views().history->findChild<QUndoView*>();
    const auto& history = page.window().control().history();
    const int last = list->model()->rowCount() - 1;
    QCOMPARE(list->model()->index(last, 0).data().toString(), QString("Stop all robots"));
    QVERIFY(history.reasonOf(last - 1).contains("cannot be undone"));
    page.window().commands().action("view.dock.history")->trigger();
    QTRY_VERIFY(list->isVisible());
    const QImage seen = list->viewport()->grab().toImage();
    const QRect row = list->visualRect(list->currentIndex());
    QCOMPARE(list->currentIndex().row(), last);
    const QColor fill = seen.pixelColor(row.right() - 2, row.center().y());
    double best = 1.0;
    for (int x = row.left(); x < row.center().x(); ++x)
        for (int y = row.top(); y <= row.bottom(); ++y)
            best = std::max(best, widgets::contrast(seen.pixelColor(x, y), fill));
    QVERIFY2(best >= 4.5, qPrintable(QString("the selected row can hardly be read: %1").arg(best)));
    page.window().commands().action("edit.undo")->trigger();
    QVERIFY(!page.map().area());
}

void tst_WindowUndo::aLayoutOfOnesOwnComesBackAfterTheNextStart() {
    QTemporaryDir settings;
    WindowSetup setup{.settings_folder = settings.path()};
    widgets::DockLayout saved;
    {
        WindowPage page(setup);
        page.window().commands().action("view.debug")->trigger();
        page.window().commands().action("view.layout_save")->trigger();
        QTRY_VERIFY(dialogOf(page));
        QVERIFY(!dialogOf(page)->isModal());
        saved = widgets::layoutOf(page.window());
        auto* const name = dialogOf(page)->findChild<QLineEdit*>();
        name->selectAll();
        QTest::keyClicks(name, "My messages");
        QTest::keyClick(name, Qt::Key_Return);
        page.screenshot("layout_dialog");
        QTRY_COMPARE_WITH_TIMEOUT(
            QDir(settings.path()).entryList({"*"}, QDir::AllEntries | QDir::NoDotAndDotDot).size() > 0, true, soon_ms);
    }
    WindowPage page(setup);
    std::function<void()> show;
    QTRY_VERIFY_WITH_TIMEOUT(
        [&] {
            for (const widgets::PaletteOffer& offer : page.window().commands().offers())
                if (offer.text == "Layout: My messages")
                    show = offer.run;
            return static_cast<bool>(show);
        }(),
        soon_ms);
    page.window().commands().action("view.operate")->trigger();
    QTRY_VERIFY(page.window().views().messages_dock->visibleRegion().isEmpty());
    show();
    QTRY_VERIFY(!page.window().views().messages_dock->visibleRegion().isEmpty());
    QCOMPARE(widgets::layoutOf(page.window()).edges.at("bottom").place.front, QString("messages"));
}

void tst_WindowUndo::aDamagedLayoutIsOneNotice() {
    QTemporaryDir settings;
    QString folder;
    {
        WindowPage page({.settings_folder = settings.path()});
        folder = QFileInfo(QSettings().fileName()).path() + "/layouts";
    }
    QVERIFY(QDir().mkpath(folder));
    QFile file(folder + "/Broken.json");
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{\"format\": ") > 0);
    file.close();
    WindowPage page({.settings_folder = settings.path()});
    QTRY_VERIFY_WITH_TIMEOUT(page.notified("Broken.json").contains("delete it and save the layout again"), soon_ms);
}

USAR_TEST(tst_WindowUndo)

} // namespace tst_window_undo

#include "tst_window_undo.moc"
