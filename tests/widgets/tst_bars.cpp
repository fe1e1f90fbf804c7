#include <algorithm>
#include <cmath>

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"
#include "widgets/bars/connection_bar.h"
#include "widgets/bars/strips.h"
#include "widgets/bars/time_bar.h"
#include "widgets/map/layers_panel.h"
#include "widgets/panels/behavior_parts.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace tst_bars {

using namespace usar;
using namespace usar::widgets;

namespace {

template <class Widget>
Widget* named(const QWidget& panel, const QString& accessible_name) {
    const auto all = panel.findChildren<Widget*>();
    const auto found = std::ranges::find(all, accessible_name, &QWidget::accessibleName);
    return found == all.end() ? nullptr : *found;
}

} // namespace

class tst_Bars : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }
    void saysTheStateInWords_data();
    void saysTheStateInWords();
    void aNewThemeColorsTheState();
    void aReasonIsWholeWhereThereIsRoom();
    void whatDoesNotFitLosesItsLastPartFirst_data();
    void whatDoesNotFitLosesItsLastPartFirst();
    void connectsToWhatIsTyped();
    void embeddedSimulatorNeedsNoAddress();
    void addressIsKeptForTheRealServer();
    void secondsToTheNextTryRunDown();
    void countdownIsSeenBesideALongReason();
    void disconnectsAndGivesUpWaiting();
    void addressIsLockedWhileConnected();
    void whatCannotBeChosenMakesRoom();
    void rateKeepsItsWidth();
    void figuresOfTheLinkOpenFromTheRate();
    void pauseAsksAndEnablesTheStep();
    void speedsAreOffered();
    void withoutARobotTheBarSaysWhyTimeIsNotFaster();
    void settersAreSilent();
    void realServerHasOnlyAClock();
    void clockIsUnknownAtFirst();
    void stopButtonIsReachedByKeys();
    void progressIsSaidOfWhatTakesLong();
    void layerRowsTellEyeAndOpacity();
    void layersBeginAsTheMapDoes();
    void layersAreRememberedAcrossStarts();
    void strangeLayerStatesChangeNothing_data();
    void strangeLayerStatesChangeNothing();
    void layersPanelIsTheLegendOfTheMarks();
    void typedAreaIsTold();
    void crossedCornersAreOrdered();
    void areaOfNoSizeIsToldAsNone();
    void areaOutsideTheWorldIsShownAndMarked();
    void areaFormTellsHowMuchCannotBeFlown_data();
    void areaFormTellsHowMuchCannotBeFlown();
    void withoutLimitsNothingIsMarked();
    void everythingHasNameAndTooltip();
};

void tst_Bars::saysTheStateInWords_data() {
    QTest::addColumn<ConnectionStatus>("status");
    QTest::addColumn<QString>("words");
    QTest::addColumn<StateShape>("shape");
    using enum ConnectionState;
    const QString refused = QStringLiteral("No answer from 10.0.0.5:3000. Is USARSim running there?");
    QTest::newRow("off") << ConnectionStatus{} << QStringLiteral("Not connected") << StateShape::Off;
    QTest::newRow("failed") << ConnectionStatus{Disconnected, {}, refused, {}} << refused << StateShape::Bad;
    QTest::newRow("connecting") << ConnectionStatus{Connecting, {}, {}, {}} << QStringLiteral("Connecting…")
                                << StateShape::Busy;
    QTest::newRow("connected") << ConnectionStatus{Connected, QStringLiteral("tall_test"), {}, {}}
                               << QStringLiteral("Connected · tall_test") << StateShape::Good;
    QTest::newRow("open to other machines")
        << ConnectionStatus{Connected, QStringLiteral("tall_test"), {}, {}, QStringLiteral("10.1.0.0/16")}
        << QStringLiteral("Connected · tall_test · open to 10.1.0.0/16") << StateShape::Good;
    QTest::newRow("waiting") << ConnectionStatus{Waiting, {}, refused, Seconds(4.0)}
                             << refused + QStringLiteral(" Retrying in 4 s.") << StateShape::Waiting;
}

void tst_Bars::saysTheStateInWords() {
    QFETCH(ConnectionStatus, status);
    ConnectionBar bar;
    bar.setStatus(status);
    QTEST(bar.statusText(), "words");
    QTEST(bar.findChild<StateDot*>()->state(), "shape");
}

void tst_Bars::aNewThemeColorsTheState() {
    ConnectionBar bar;
    bar.setStatus({ConnectionState::Connected, QStringLiteral("tall_test"), {}, {}});
    bar.show();
    const auto* const state = named<QLabel>(bar, QStringLiteral("State of the connection"));
    for (int i = 0; i < 4; ++i) // Widgets learn of a theme in no particular order.
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            applyTheme(theme);
            QCOMPARE(state->palette().color(QPalette::WindowText), tokens(theme).ok);
        }
    bar.setStatus({ConnectionState::Disconnected, {}, QStringLiteral("Nothing listens there."), {}});
    QCOMPARE(state->palette().color(QPalette::WindowText), tokens().danger);
}

void tst_Bars::aReasonIsWholeWhereThereIsRoom() {
    ConnectionBar bar;
    bar.ensurePolished();
    const QString reason =
        QStringLiteral("Nothing listens at 127.0.0.1:3000. Start the server, or choose another port.");
    const int usual_px = bar.sizeHint().width();
    const int least_px = bar.minimumSizeHint().width();
    bar.setStatus({ConnectionState::Disconnected, {}, reason, {}});
    auto* const state = named<QLabel>(bar, QStringLiteral("State of the connection"));
    bar.show();
    bar.resize(bar.sizeHint());
    QVERIFY(state->width() >= state->fontMetrics().horizontalAdvance(reason));
    QCOMPARE(bar.minimumSizeHint().width(), least_px); // Elsewhere it is cut, and the tooltip has it.
    QVERIFY(state->toolTip().contains(reason));
    bar.setStatus({});
    QCOMPARE(bar.sizeHint().width(), usual_px);
}

void tst_Bars::whatDoesNotFitLosesItsLastPartFirst_data() {
    QTest::addColumn<QString>("room_for");
    QTest::addColumn<QString>("shown");
    QTest::newRow("all of it") << "R1: you drive · keys"
                               << "R1: you drive · keys";
    QTest::newRow("a part less") << "R1: you drive · ke"
                                 << "R1: you drive";
    QTest::newRow("just the first") << "R1: you drive"
                                    << "R1: you drive";
    QTest::newRow("less than the first") << "R1: you …"
                                         << "R1: you …";
}

void tst_Bars::whatDoesNotFitLosesItsLastPartFirst() {
    QFETCH(QString, room_for);
    const QFontMetrics metrics(QApplication::font());
    QTEST(fittedText("R1: you drive · keys", metrics, metrics.horizontalAdvance(room_for)), "shown");
}

void tst_Bars::connectsToWhatIsTyped() {
    ConnectionBar bar;
    QSignalSpy wanted(&bar, &ConnectionBar::connectRequested);
    bar.show();
    bar.setServer(ServerChoice::Real);
    bar.setAddress({}, 3001);
    auto* host = bar.findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
    QTest::keyClick(host, Qt::Key_Return);
    QCOMPARE(wanted.count(), 0);
    QTest::keyClicks(host, QStringLiteral(" 10.0.0.5 "));
    QTest::keyClick(host, Qt::Key_Return);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].value<ServerChoice>(), ServerChoice::Real);
    QCOMPARE(wanted[0][1].toString(), QStringLiteral("10.0.0.5"));
    QCOMPARE(wanted[0][2].value<quint16>(), quint16(3001));
}

void tst_Bars::embeddedSimulatorNeedsNoAddress() {
    ConnectionBar bar;
    QSignalSpy wanted(&bar, &ConnectionBar::connectRequested);
    bar.show();
    bar.setAddress({}, 3000);
    QVERIFY(!bar.findChild<QSpinBox*>()->isVisible());
    QTest::mouseClick(bar.findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].value<ServerChoice>(), ServerChoice::Embedded);
}

void tst_Bars::addressIsKeptForTheRealServer() {
    ConnectionBar bar;
    QSignalSpy wanted(&bar, &ConnectionBar::connectRequested);
    bar.setAddress(QStringLiteral("10.0.0.5"), 4321);
    QTest::mouseClick(bar.findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(wanted[0][1].toString(), QString());
    QCOMPARE(wanted[0][2].value<quint16>(), quint16(0));
    bar.setServer(ServerChoice::Real);
    QTest::mouseClick(bar.findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(wanted[1][1].toString(), QStringLiteral("10.0.0.5"));
    QCOMPARE(wanted[1][2].value<quint16>(), quint16(4321));
}

void tst_Bars::secondsToTheNextTryRunDown() {
    ConnectionBar bar;
    const ConnectionStatus waiting{ConnectionState::Waiting, {}, QStringLiteral("Refused."), Seconds(2.0)};
    bar.setStatus(waiting);
    auto* second = bar.findChild<QTimer*>();
    QVERIFY(second && second->isActive());
    const auto tick = [&] {
        QTimerEvent one(second->timerId());
        QCoreApplication::sendEvent(second, &one);
    };
    tick();
    QCOMPARE(bar.statusText(), QStringLiteral("Refused. Retrying in 1 s."));
    bar.setStatus(waiting); // the same news does not begin anew
    tick();
    tick();
    QCOMPARE(bar.statusText(), QStringLiteral("Refused. Retrying now."));
    bar.setStatus({ConnectionState::Connecting, {}, {}, {}});
    QVERIFY(!second->isActive());
}

void tst_Bars::countdownIsSeenBesideALongReason() {
    ConnectionBar bar;
    bar.setServer(ServerChoice::Real);
    bar.resize(720, 40);
    bar.show();
    bar.setStatus({ConnectionState::Waiting, {}, QString(200, u'x'), Seconds(4.0)});
    QCoreApplication::sendPostedEvents();
    const auto labels = bar.findChildren<QLabel*>();
    const auto retry = std::ranges::find(labels, QStringLiteral("Retrying in 4 s."), &QLabel::text);
    QVERIFY(retry != labels.end());
    QVERIFY((*retry)->width() >= (*retry)->sizeHint().width());
    QVERIFY(bar.rect().contains((*retry)->geometry()));
    bar.setStatus({ConnectionState::Connected, {}, {}, {}});
    QVERIFY((*retry)->isHidden());
}

void tst_Bars::disconnectsAndGivesUpWaiting() {
    ConnectionBar bar;
    QSignalSpy unwanted(&bar, &ConnectionBar::disconnectRequested);
    auto* button = bar.findChild<QPushButton*>();
    bar.setStatus({ConnectionState::Connected, {}, {}, {}});
    QCOMPARE(button->text(), QStringLiteral("Disconnect"));
    QTest::mouseClick(button, Qt::LeftButton);
    bar.setStatus({ConnectionState::Waiting, {}, QStringLiteral("Refused."), Seconds(2.0)});
    QCOMPARE(button->text(), QStringLiteral("Cancel"));
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(unwanted.count(), 2);
}

void tst_Bars::addressIsLockedWhileConnected() {
    ConnectionBar bar;
    bar.setServer(ServerChoice::Real);
    bar.setStatus({ConnectionState::Connected, {}, {}, {}});
    QVERIFY(!bar.findChild<QSpinBox*>()->isEnabled());
    QVERIFY(!bar.findChild<QComboBox*>()->isEnabled());
    bar.setStatus({});
    QVERIFY(bar.findChild<QSpinBox*>()->isEnabled());
}

void tst_Bars::whatCannotBeChosenMakesRoom() {
    ConnectionBar bar;
    bar.show();
    bar.setServer(ServerChoice::Real);
    bar.setAddress("robots.example", 3001);
    bar.setStatus({ConnectionState::Connected, "tall_test", {}, {}});
    auto* const servers = bar.findChild<QComboBox*>();
    auto* const button = bar.findChild<QPushButton*>();
    const int wide_px = bar.minimumSizeHint().width();
    bar.setRoom(BarRoom::Medium);
    QVERIFY(servers->isHidden() && bar.findChild<QSpinBox*>()->isHidden());
    QCOMPARE(button->text(), QString("Disconnect"));
    QVERIFY2(bar.findChild<ElidedLabel*>()->toolTip().contains("robots.example:3001"),
             qPrintable(bar.findChild<ElidedLabel*>()->toolTip()));
    const int medium_px = bar.minimumSizeHint().width();
    bar.setRoom(BarRoom::Narrow);
    QCOMPARE(button->text(), QString());
    QCOMPARE(button->accessibleName(), QString("Disconnect"));
    const int narrow_px = bar.minimumSizeHint().width();
    QVERIFY2(wide_px > medium_px && medium_px > narrow_px,
             qPrintable(QString("%1 %2 %3").arg(wide_px).arg(medium_px).arg(narrow_px)));
    bar.setStatus({}); // now it can be chosen, and must be
    QVERIFY(!servers->isHidden() && !bar.findChild<QSpinBox*>()->isHidden());
    QCOMPARE(button->text(), QString("Connect"));
}

void tst_Bars::rateKeepsItsWidth() {
    ConnectionBar bar;
    bar.resize(900, 40);
    bar.show();
    auto* dot = bar.findChild<StateDot*>();
    bar.setRate(3.0);
    const int before = dot->x();
    bar.setRate(4800.0, Seconds(0.00123));
    QCoreApplication::sendPostedEvents();
    QCOMPARE(dot->x(), before);
}

void tst_Bars::figuresOfTheLinkOpenFromTheRate() {
    ConnectionBar bar;
    bar.resize(900, 40);
    bar.show();
    QVERIFY(QTest::qWaitForWindowExposed(&bar));
    bar.setRate(48.0);
    LinkFigures figures;
    figures.counts = {1234, 56, 1'500'000, 240, 2, 1, 3, 4};
    figures.rates = {48.0, 10.0, 61'000.0, 0.0};
    figures.not_shown = 7;
    figures.round_trip = Seconds(0.0123);
    bar.panel()->setFigures(figures);
    bar.panel()->setName(QStringLiteral("R1"));
    QTest::mouseClick(bar.findChild<QToolButton*>(), Qt::LeftButton);
    QTRY_VERIFY(bar.panel()->isVisible());
    const auto said = [&](const char* name) {
        for (const QLabel* label : bar.panel()->findChildren<QLabel*>())
            if (label->accessibleName() == QLatin1String(name))
                return label->text();
        return QString();
    };
    QCOMPARE(said("Lines in"), QStringLiteral("1,234"));
    QCOMPARE(said("Bytes in"), QStringLiteral("1.5 MB"));
    QCOMPARE(said("Bytes in per second"), QStringLiteral("61.0 kB"));
    QCOMPARE(said("Unknown types"), QStringLiteral("2"));
    QCOMPARE(said("Malformed"), QStringLiteral("1"));
    QCOMPARE(said("Dropped"), QStringLiteral("3"));
    QCOMPARE(said("DRIVE replaced"), QStringLiteral("4"));
    QCOMPARE(said("Not shown"), QStringLiteral("7"));
    QCOMPARE(said("Round trip"), QStringLiteral("12 ms"));
    QCOMPARE(trafficSummary(figures.counts), QStringLiteral("1,234 in · 56 out · 2 unknown · 1 malformed · 3 dropped"));
    figures.counts.unknown = figures.counts.malformed = figures.counts.dropped = 0;
    QCOMPARE(trafficSummary(figures.counts), QStringLiteral("1,234 in · 56 out · no errors"));
}

void tst_Bars::pauseAsksAndEnablesTheStep() {
    TimeBar bar;
    QSignalSpy paused(&bar, &TimeBar::pauseRequested);
    QSignalSpy stepped(&bar, &TimeBar::stepRequested);
    const auto buttons = bar.findChildren<QToolButton*>();
    QTest::mouseClick(buttons[1], Qt::LeftButton);
    QCOMPARE(stepped.count(), 0);
    QTest::mouseClick(buttons[0], Qt::LeftButton);
    QCOMPARE(paused.takeFirst()[0].toBool(), true);
    QTest::mouseClick(buttons[1], Qt::LeftButton);
    QCOMPARE(stepped.count(), 1);
    QTest::mouseClick(buttons[0], Qt::LeftButton);
    QCOMPARE(paused.takeFirst()[0].toBool(), false);
}

void tst_Bars::speedsAreOffered() {
    TimeBar bar;
    QCOMPARE(bar.speed(), 1.0);
    QSignalSpy asked(&bar, &TimeBar::speedRequested);
    bar.show();
    auto* combo = bar.findChild<QComboBox*>();
    QTest::keyClick(combo, Qt::Key_End);
    QVERIFY(std::isinf(asked.last()[0].toDouble()));
    QTest::keyClick(combo, Qt::Key_Home);
    QCOMPARE(asked.last()[0].toDouble(), 0.1);
}

void tst_Bars::withoutARobotTheBarSaysWhyTimeIsNotFaster() {
    TimeBar bar;
    const auto* const factor = bar.findChildren<QLabel*>()[1];
    bar.setRealTimeFactor(1.0);
    bar.setLimited(true);
    QVERIFY2(factor->text().startsWith("RTF"), "real time is what was asked for");
    bar.setSpeed(INFINITY);
    QCOMPARE(factor->text(), QStringLiteral("1×: no robot"));
    QVERIFY(factor->toolTip().contains("as soon as there is one"));
    bar.setLimited(false);
    QVERIFY(factor->text().startsWith("RTF"));
}

void tst_Bars::settersAreSilent() {
    TimeBar bar;
    QSignalSpy asked(&bar, &TimeBar::speedRequested);
    QSignalSpy paused(&bar, &TimeBar::pauseRequested);
    bar.setSpeed(7.0);
    QCOMPARE(bar.speed(), 5.0);
    bar.setSpeed(INFINITY);
    QVERIFY(std::isinf(bar.speed()));
    bar.setSpeed(1.0);
    QCOMPARE(bar.speed(), 1.0);
    bar.setPaused(true);
    QVERIFY(bar.paused());
    QCOMPARE(asked.count() + paused.count(), 0);
}

void tst_Bars::realServerHasOnlyAClock() {
    TimeBar bar;
    bar.show();
    bar.setSteerable(false);
    int visible = 0;
    for (const QWidget* child : bar.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        visible += child->isVisible() ? 1 : 0;
    QCOMPARE(visible, 1);
}

void tst_Bars::clockIsUnknownAtFirst() {
    TimeBar bar;
    auto* clock = bar.findChildren<QLabel*>()[0];
    QCOMPARE(clock->text(), QStringLiteral("--:--:--"));
    QVERIFY(clock->minimumWidth() >=
            clock->sizeHint().width()); // It is not cut, and nothing moves with the first time.
    bar.setClock(Seconds(751.0));
    QCOMPARE(clock->text(), QStringLiteral("00:12:31"));
}

void tst_Bars::stopButtonIsReachedByKeys() {
    const std::unique_ptr<QPushButton> button(makeStopButton(QStringLiteral("STOP"), QStringLiteral("Stops R1")));
    QSignalSpy clicked(button.get(), &QPushButton::clicked);
    QTest::keyClick(button.get(), Qt::Key_Space);
    QCOMPARE(clicked.count(), 1);
    QCOMPARE(button->text(), QStringLiteral("STOP"));
    QCOMPARE(button->toolTip(), QStringLiteral("Stops R1"));
    QCOMPARE(button->property("role").toString(), QStringLiteral("stop"));
}

void tst_Bars::progressIsSaidOfWhatTakesLong() {
    ProgressStrip strip;
    QSignalSpy cancelled(&strip, &ProgressStrip::cancelRequested);
    strip.begin("Opening the quick one");
    strip.end();
    const test::Beats delays(350); // before it shows itself
    QVERIFY2(test::holdsUntil([&] { return !strip.isVisible(); }, [&] { return delays.count() >= 1; }),
             "what ends soon needs no strip");
    strip.begin("Taking up run.usarsnap");
    QVERIFY(!strip.isVisible());
    QTRY_VERIFY(strip.isVisible());
    QCOMPARE(strip.findChild<QLabel*>()->text(), QString("Taking up run.usarsnap…"));
    strip.setProgress(Seconds{90.0}, Seconds{3600.0});
    QCOMPARE(strip.findChild<QLabel*>()->text(), QString("Taking up run.usarsnap: 1 min 30 s of 1 h 00 min"));
    QCOMPARE(strip.findChild<QProgressBar*>()->value(), strip.findChild<QProgressBar*>()->maximum() / 40);
    strip.setProgress(Seconds{0.0}, Seconds{0.0}); // a run of no length
    QTest::mouseClick(strip.findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(cancelled.count(), 1);
    strip.end();
    QVERIFY(!strip.isVisible());
}

void tst_Bars::layerRowsTellEyeAndOpacity() {
    LayersPanel panel;
    QSignalSpy changed(&panel, &LayersPanel::layerChanged);
    panel.setLayer(MapLayer::Heights, {true, 0.6});
    QCOMPARE(changed.count(), 0);
    auto* eye = named<QToolButton>(panel, QStringLiteral("Show Height map"));
    QTest::mouseClick(eye, Qt::LeftButton);
    QCOMPARE(changed.last()[0].value<MapLayer>(), MapLayer::Heights);
    QCOMPARE(changed.last()[1].value<LayerState>(), (LayerState{false, 0.6}));
    QTest::mouseClick(eye, Qt::LeftButton);
    QTest::keyClick(named<QSlider>(panel, QStringLiteral("Opacity of Height map")), Qt::Key_Right);
    QCOMPARE(changed.last()[1].value<LayerState>(), (LayerState{true, 0.61}));
}

void tst_Bars::layersBeginAsTheMapDoes() {
    const LayersPanel panel;
    const MapContent map;
    for (std::size_t i = 0; i < map_layer_count; ++i)
        QCOMPARE(panel.layer(static_cast<MapLayer>(i)), map.layers[i]);
    QCOMPARE(panel.layer(MapLayer::World).opacity, 0.4);
}

void tst_Bars::layersAreRememberedAcrossStarts() {
    LayersPanel before;
    before.setLayer(MapLayer::Heights, {true, 0.6});
    before.setLayer(MapLayer::Grid, {false, 0.25});
    LayersPanel after;
    QSignalSpy changed(&after, &LayersPanel::layerChanged);
    QVERIFY(after.restoreState(before.saveState()));
    for (std::size_t i = 0; i < map_layer_count; ++i)
        QCOMPARE(after.layer(static_cast<MapLayer>(i)), before.layer(static_cast<MapLayer>(i)));
    QCOMPARE(changed.count(), 2);
}

void tst_Bars::strangeLayerStatesChangeNothing_data() {
    QTest::addColumn<QByteArray>("state");
    QTest::addColumn<bool>("taken");
    QTest::newRow("nothing saved yet") << QByteArray() << false;
    QTest::newRow("not JSON") << QByteArray("eyes") << false;
    QTest::newRow("layers of another version") << QByteArray(R"({"Clouds":{"visible":false}})") << true;
    QTest::newRow("words for figures") << QByteArray(R"({"Grid":{"visible":"no","opacity":"half"}})") << true;
}

void tst_Bars::strangeLayerStatesChangeNothing() {
    QFETCH(QByteArray, state);
    LayersPanel panel;
    QSignalSpy changed(&panel, &LayersPanel::layerChanged);
    QTEST(panel.restoreState(state), "taken");
    QCOMPARE(changed.count(), 0);
}

void tst_Bars::layersPanelIsTheLegendOfTheMarks() {
    applyTheme(Theme::Dark);
    LayersPanel panel;
    panel.show();
    const auto labels = panel.findChildren<QLabel*>();
    const auto swatches = panel.findChildren<LayerSwatch*>();
    for (const agent::MarkKind kind : all_mark_kinds) {
        const auto name = std::ranges::find(labels, markName(kind), &QLabel::text);
        QVERIFY2(name != labels.end(), qPrintable(markName(kind)));
        const int middle = (*name)->geometry().center().y();
        const auto beside = std::ranges::find_if(swatches, [&](const LayerSwatch* swatch) {
            return swatch->geometry().top() <= middle && swatch->geometry().bottom() >= middle;
        });
        QVERIFY(beside != swatches.end());
        const QImage picture = (*beside)->grab().toImage();
        bool has_color = false; // Not always in the middle: a landing is a ring.
        for (int x = 0; x < picture.width(); ++x)
            has_color |= picture.pixelColor(x, picture.height() / 2) == markColor(kind);
        QVERIFY2(has_color, qPrintable(markName(kind)));
    }
}

void tst_Bars::typedAreaIsTold() {
    AreaForm form;
    QSignalSpy changed(&form, &AreaForm::areaChanged);
    form.setArea(Rectangle{Vec2(0, 0), Vec2(60, 40)});
    QCOMPARE(changed.count(), 0);
    auto* box = form.findChildren<QDoubleSpinBox*>()[1];
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("75.5"));
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed[0][0].value<Rectangle>(), (Rectangle{Vec2(0, 0), Vec2(75.5, 40)}));
}

void tst_Bars::crossedCornersAreOrdered() {
    AreaForm form;
    form.setArea(Rectangle{Vec2(0, 0), Vec2(60, 40)});
    form.findChildren<QDoubleSpinBox*>()[0]->setValue(80.0);
    QCOMPARE(form.area(), (Rectangle{Vec2(60, 0), Vec2(80, 40)}));
}

void tst_Bars::areaOfNoSizeIsToldAsNone() {
    AreaForm form;
    form.setArea(Rectangle{Vec2(5, 0), Vec2(60, 40)});
    QSignalSpy changed(&form, &AreaForm::areaChanged);
    form.findChildren<QDoubleSpinBox*>()[1]->setValue(5.0);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed[0][0].value<Rectangle>(), Rectangle{});
    QVERIFY(form.findChild<QLabel*>(QStringLiteral("size"))->text().contains(QStringLiteral("No area")));
}

void tst_Bars::areaOutsideTheWorldIsShownAndMarked() {
    AreaForm form;
    form.setLimits({Vec2(-50, -50), Vec2(50, 50)});
    form.setArea(Rectangle{Vec2(-2e5, -10), Vec2(20, 40)});
    QCOMPARE(form.area(), (Rectangle{Vec2(-2e5, -10), Vec2(20, 40)}));
    const auto boxes = form.findChildren<QDoubleSpinBox*>();
    const auto marked = [](const QDoubleSpinBox* box) {
        return box->palette().color(QPalette::Text) == tokens().caution &&
               box->toolTip().contains(QStringLiteral("outside the world"));
    };
    QVERIFY(marked(boxes[0]));
    QVERIFY(!marked(boxes[1]));
    boxes[3]->setValue(60.0);
    QVERIFY(marked(boxes[3]));
    const QString words =
        form.findChild<QLabel*>(QStringLiteral("size"))->text().replace(QChar(QChar::Nbsp), QChar(u' '));
    QVERIFY2(words.contains(QStringLiteral("Lowest x, Highest y: outside the world, which spans x −50.0 … 50.0 m")),
             qPrintable(words));
}

void tst_Bars::areaFormTellsHowMuchCannotBeFlown_data() {
    QTest::addColumn<Rectangle>("area");
    QTest::addColumn<QString>("words");
    QTest::newRow("inside") << Rectangle{Vec2(0, 0), Vec2(10, 10)} << QString();
    QTest::newRow("a quarter") << Rectangle{Vec2(-60, 0), Vec2(-20, 10)}
                               << QStringLiteral("25.0 % of the area lies outside and is not flown.");
    QTest::newRow("all of it") << Rectangle{Vec2(60, 60), Vec2(70, 70)}
                               << QStringLiteral("All of the area is there and cannot be flown.");
}

void tst_Bars::areaFormTellsHowMuchCannotBeFlown() {
    QFETCH(Rectangle, area);
    QFETCH(QString, words);
    AreaForm form;
    form.setLimits({Vec2(-50, -50), Vec2(50, 50)});
    form.setArea(area);
    const QString text = form.findChild<QLabel*>(QStringLiteral("size"))->text();
    QVERIFY2(words.isEmpty() ? !text.contains(QStringLiteral("flown")) : text.contains(words), qPrintable(text));
}

void tst_Bars::withoutLimitsNothingIsMarked() {
    AreaForm form;
    form.setLimits({Vec2(-50, -50), Vec2(50, 50)});
    form.setArea(Rectangle{Vec2(-200, -10), Vec2(20, 40)});
    form.setLimits({});
    QVERIFY(!form.findChildren<QDoubleSpinBox*>()[0]->toolTip().contains(QStringLiteral("outside")));
    QVERIFY(!form.findChild<QLabel*>(QStringLiteral("size"))->text().contains(QStringLiteral("outside")));
}

void tst_Bars::everythingHasNameAndTooltip() {
    ConnectionBar connection;
    TimeBar time;
    LayersPanel layers;
    AreaForm area;
    for (QWidget* panel : std::initializer_list<QWidget*>{&connection, &time, &layers, &area})
        for (const QWidget* child : panel->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            if (child->focusPolicy() == Qt::NoFocus || qobject_cast<const QLabel*>(child))
                continue;
            const auto* button = qobject_cast<const QPushButton*>(child);
            QVERIFY2(!child->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
                     child->metaObject()->className());
            QVERIFY2(!child->toolTip().isEmpty(), qPrintable(child->accessibleName()));
        }
}

USAR_TEST(tst_Bars)

} // namespace tst_bars

#include "tst_bars.moc"
