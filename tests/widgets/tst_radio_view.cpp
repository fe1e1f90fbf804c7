#include <QAbstractItemModelTester>
#include <QColor>
#include <QImage>
#include <QObject>
#include <QSignalSpy>
#include <QString>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/map_view.h"
#include "widgets/panels/radio_view.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_radio_view {

using namespace usar;
using namespace usar::widgets;

namespace {

std::vector<RadioLink> twoLinks(double strength_dbm) {
    return {{"R1", "R2", strength_dbm}, {"Base", "R1", std::nullopt}};
}

/// Pixels in that color.
int count(const QImage& picture, const QColor& color) {
    int found = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            found += picture.pixelColor(x, y) == color ? 1 : 0;
    return found;
}

} // namespace

class tst_RadioView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::Dark); }

    void qualityIsCountedInWalls_data() {
        QTest::addColumn<std::optional<double>>("strength_dbm");
        QTest::addColumn<QString>("word");
        QTest::addColumn<int>("bars");
        const auto row = [](const char* name, std::optional<double> dbm, const char* word, int bars) {
            QTest::newRow(name) << dbm << QString(word) << bars;
        };
        row("nothing known", std::nullopt, "not heard", 0);
        row("below the cut-off", -93.1, "no link", 0);
        row("on the cut-off", -93.0, "weak", 1);
        row("one wall more ends it", -87.0, "weak", 1);
        row("two do", -86.0, "fair", 2);
        row("three do", -80.0, "good", 3);
        row("near", -45.0, "good", 4);
    }

    void qualityIsCountedInWalls() {
        QFETCH(std::optional<double>, strength_dbm);
        QFETCH(QString, word);
        QFETCH(int, bars);
        QCOMPARE(radioWord(radioQuality(strength_dbm)), word);
        QCOMPARE(radioBars(strength_dbm), bars);
    }

    void rowsAreSentencesInTheOrderOfNames() {
        RadioLinkModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.take(twoLinks(-62.34));
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.index(0).data().toString(), QString("Base and R1: not heard"));
        QCOMPARE(model.index(1).data().toString(), QString("R1 and R2: −62.3 dBm, good"));
        model.take({{"R1", "R2", -95.0}});
        QCOMPARE(model.rowCount(), 1);
        QCOMPARE(model.index(0).data().toString(), QString("R1 and R2: −95.0 dBm, no link"));
        model.take({});
        QCOMPARE(model.rowCount(), 0);
    }

    void historyIsKeptOfTwoMinutes() {
        RadioLinkModel model;
        QSignalSpy resets(&model, &RadioLinkModel::modelReset);
        for (int i = 0; i < 200; ++i)
            model.take(twoLinks(-50.0 - i / 10.0));
        const RadioRow& row = model.row(1);
        QCOMPARE(row.history_dbm.size(), RadioLinkModel::most_samples);
        QCOMPARE(row.history_dbm.back(), -69.9);
        QCOMPARE(row.history_dbm.front(), -50.0 - 80 / 10.0);
        QVERIFY(std::isnan(model.row(0).history_dbm.back()));
        QCOMPARE(resets.size(), 1); // a selection lives on
    }

    void withoutPairsItSaysWhatToDo() {
        RadioView view;
        view.emptyState()->setText("No radio links yet", "Spawn two robots.");
        view.resize(500, 200);
        view.show();
        QVERIFY(view.emptyState()->isVisible());
        view.take(twoLinks(-60.0));
        QVERIFY(!view.emptyState()->isVisible());
        view.take({});
        QVERIFY(view.emptyState()->isVisible());
    }

    void paintsInEveryWidthAndTheme() {
        RadioView view;
        view.setSource("Wireless server at 127.0.0.1:50000");
        for (int i = 0; i < 60; ++i)
            view.take(
                {{"R1", "R2", -60.0 - i / 4.0}, {"A very long name of a robot", "R1", -99.0}, {"Base", "R2", {}}});
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            applyTheme(theme);
            for (const int width : {240, 420, 900}) {
                view.resize(width, 220);
                const QImage picture = view.grab().toImage();
                if (width >= 420) // room for the history with its cut-off
                    QVERIFY(count(picture, tokens().danger) > 10);
                QVERIFY(count(picture, tokens().ok) > 10); // bars of R1 and R2
            }
        }
        applyTheme(Theme::Dark);
    }

    void theMapDrawsLinksInTheColorOfTheirQuality() {
        MapView map;
        map.resize(400, 400);
        map.setWorld({{-20, -20}, {20, 20}}, "test");
        map.setRobot({"R1", 1, Pose{{-10, 0, 0}, 0, 0, 0}});
        map.setRobot({"Base", 2, Pose{{10, 0, 0}, 0, 0, 0}, false, true});
        map.fitWorld();
        const auto drawn = [&](double dbm, const QColor& color) {
            map.setRadioLinks({{"Base", "R1", dbm}, {"R1", "Gone", -50.0}});
            return count(map.grab().toImage(), color);
        };
        QVERIFY(drawn(-60.0, tokens().ok) == 0); // hidden at first
        map.setLayer(MapLayer::Radio, {true, 1.0});
        QVERIFY(drawn(-60.0, tokens().ok) > 100);
        QVERIFY(drawn(-90.0, tokens().caution) > 100);
        const int dashed = drawn(-95.0, tokens().danger);
        QVERIFY2(dashed > 20 && dashed < drawn(-60.0, tokens().ok), qPrintable(QString::number(dashed)));
    }
};

USAR_TEST(tst_RadioView)

} // namespace tst_radio_view

#include "tst_radio_view.moc"
