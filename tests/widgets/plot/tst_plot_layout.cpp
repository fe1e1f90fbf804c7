#include <limits>

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/plot/plot_layout.h"

namespace tst_plot_layout {

using namespace usar;
using namespace usar::widgets;

namespace {

PlotLayout twoCanvases() {
    PlotLayout layout;
    layout.canvases = {{{"R1", "SEN Sonar/F1/range", "m"}, {"R2", "SEN Sonar/F1/range", "m"}},
                       {{"", "STA/battery", ""}}};
    layout.follow_robot = false;
    layout.statistics = true;
    layout.window_s = 300.0;
    return layout;
}

} // namespace

class tst_PlotLayout : public QObject {
    Q_OBJECT
private slots:
    void aLayoutComesBackFromItsText();
    void allOfTheTimeIsAWord();
    void nothingIsTheDefault();
    void unknownKeysAreIgnored();
    void anEntryOfAnotherTypeIsNamed_data();
    void anEntryOfAnotherTypeIsNamed();
    void tooManyCanvasesAreRefused();
};

void tst_PlotLayout::aLayoutComesBackFromItsText() {
    const QByteArray text = QJsonDocument(toJson(twoCanvases())).toJson();
    const Result<PlotLayout> read = plotLayoutFrom(QJsonDocument::fromJson(text).object());
    QVERIFY(read.has_value());
    QVERIFY(*read == twoCanvases());
    QVERIFY(text.contains("\"path\": \"SEN Sonar/F1/range\"")); // a person can read it
}

void tst_PlotLayout::allOfTheTimeIsAWord() {
    PlotLayout layout;
    layout.window_s = std::numeric_limits<double>::infinity();
    QCOMPARE(toJson(layout).value("window_s").toString(), QString("all"));
    QVERIFY(plotLayoutFrom(toJson(layout)) == Result<PlotLayout>(layout));
}

void tst_PlotLayout::nothingIsTheDefault() {
    QVERIFY(plotLayoutFrom({}) == Result<PlotLayout>(PlotLayout{}));
    QCOMPARE(PlotLayout{}.canvases.size(), 1U);
}

void tst_PlotLayout::unknownKeysAreIgnored() {
    QJsonObject object = toJson(twoCanvases());
    object.insert("of a later version", 5);
    QVERIFY(plotLayoutFrom(object) == Result<PlotLayout>(twoCanvases()));
}

void tst_PlotLayout::anEntryOfAnotherTypeIsNamed_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("named");
    QTest::newRow("a flag that is a text") << QByteArray("{\"follow_robot\": \"yes\"}") << "follow_robot";
    QTest::newRow("statistics that are a number") << QByteArray("{\"statistics\": 1}") << "statistics";
    QTest::newRow("a window of no time") << QByteArray("{\"window_s\": 0}") << "window_s";
    QTest::newRow("a window in words") << QByteArray("{\"window_s\": \"long\"}") << "window_s";
    QTest::newRow("canvases that are no list") << QByteArray("{\"canvases\": {}}") << "canvases";
    QTest::newRow("no canvas") << QByteArray("{\"canvases\": []}") << "canvases";
    QTest::newRow("a canvas that is a number") << QByteArray("{\"canvases\": [1]}") << "canvases";
    QTest::newRow("series that are no list") << QByteArray("{\"canvases\": [{\"series\": 1}]}") << "series";
    QTest::newRow("a series without a path") << QByteArray("{\"canvases\": [{\"series\": [{}]}]}") << "series";
    QTest::newRow("a robot that is a number")
        << QByteArray("{\"canvases\": [{\"series\": [{\"path\": \"p\", \"robot\": 1}]}]}") << "robot";
}

void tst_PlotLayout::anEntryOfAnotherTypeIsNamed() {
    QFETCH(QByteArray, text);
    QFETCH(QString, named);
    const QJsonDocument document = QJsonDocument::fromJson(text);
    QVERIFY(document.isObject());
    const Result<PlotLayout> read = plotLayoutFrom(document.object());
    QVERIFY(!read.has_value());
    QCOMPARE(QString::fromStdString(read.error().where), named);
    QVERIFY(!read.error().mend.empty());
}

void tst_PlotLayout::tooManyCanvasesAreRefused() {
    PlotLayout layout;
    layout.canvases.resize(PlotLayout::most_canvases);
    QVERIFY(plotLayoutFrom(toJson(layout)).has_value());
    layout.canvases.emplace_back();
    QVERIFY(!plotLayoutFrom(toJson(layout)).has_value());
}

USAR_TEST(tst_PlotLayout)

} // namespace tst_plot_layout

#include "tst_plot_layout.moc"
