// Small parts that all views share: colors of states in both themes, speeds, keys of widgets, and the robots' model.
#include <map>
#include <random>
#include <set>

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/commands/key_filters.h"
#include "widgets/models/messages/notification_model.h"
#include "widgets/models/radio_links.h"
#include "widgets/models/robot_list_model.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/time_controls.h"

namespace tst_widget_parts {

using namespace usar;
using namespace usar::widgets;

namespace {

constexpr StateShape all_states[] = {StateShape::Off, StateShape::Busy, StateShape::Good, StateShape::Waiting,
                                     StateShape::Bad};

} // namespace

class tst_WidgetParts : public QObject {
    Q_OBJECT
private slots:
    void cleanup();
    void wordsOfStatesCanBeRead_data();
    void wordsOfStatesCanBeRead();
    void typesOfLinesCanBeRead_data();
    void typesOfLinesCanBeRead();
    void inkCanBeReadOnEveryFill_data();
    void inkCanBeReadOnEveryFill();
    void nearestSpeedIsShown_data();
    void nearestSpeedIsShown();
    void stepsEndAtTheEndsOfTheList();
    void widgetsKeepTheirOwnKeys_data();
    void widgetsKeepTheirOwnKeys();
    void randomChangesOfRobotsAreInOrder();
};

void tst_WidgetParts::cleanup() {
    applyTheme(Theme::Dark);
}

void tst_WidgetParts::wordsOfStatesCanBeRead_data() {
    QTest::addColumn<Theme>("theme");
    QTest::newRow("dark") << Theme::Dark;
    QTest::newRow("light") << Theme::Light;
}

void tst_WidgetParts::wordsOfStatesCanBeRead() {
    QFETCH(Theme, theme);
    applyTheme(theme);
    std::set<QRgb> colors;
    for (const StateShape state : all_states) {
        colors.insert(stateColor(state).rgb());
        for (const QColor& ground : {tokens().background, tokens().surface, tokens().raised})
            QVERIFY2(contrast(stateColor(state), ground) >= 4.5, qPrintable(stateColor(state).name()));
    }
    QCOMPARE(colors.size(), std::size(all_states));
    for (const Severity severity : {Severity::Note, Severity::Warning, Severity::Error})
        QVERIFY(contrast(severityColor(severity), tokens().surface) >= 4.5);
    for (const RadioQuality quality :
         {RadioQuality::Unknown, RadioQuality::Lost, RadioQuality::Weak, RadioQuality::Fair, RadioQuality::Good})
        QVERIFY(contrast(radioColor(quality), tokens().surface) >= 4.5);
}

void tst_WidgetParts::typesOfLinesCanBeRead_data() {
    wordsOfStatesCanBeRead_data();
}

void tst_WidgetParts::typesOfLinesCanBeRead() {
    QFETCH(Theme, theme);
    std::set<QRgb> colors;
    constexpr int last = static_cast<int>(LineFamily::Other);
    for (int family = 0; family <= last; ++family) {
        const QColor color = lineColor(static_cast<LineFamily>(family), theme);
        colors.insert(color.rgb());
        QVERIFY2(contrast(color, tokens(theme).surface) >= 4.5, qPrintable(color.name()));
    }
    QCOMPARE(colors.size(), std::size_t(last + 1));
}

void tst_WidgetParts::inkCanBeReadOnEveryFill_data() {
    QTest::addColumn<QColor>("fill");
    QTest::newRow("black") << QColor(Qt::black);
    QTest::newRow("white") << QColor(Qt::white);
    QTest::newRow("middle gray") << QColor(0x777777);
    for (int number = 1; number <= 9; ++number)
        QTest::addRow("robot %d", number) << robotColor(number);
    for (const auto& [word, color] : protocol::wire_words<protocol::TraceColor>)
        QTest::newRow(std::string(word).c_str()) << traceColor(color);
}

void tst_WidgetParts::inkCanBeReadOnEveryFill() {
    QFETCH(QColor, fill);
    QVERIFY(contrast(inkOn(fill), fill) >= 4.0);
    QCOMPARE(contrast(inkOn(fill), fill), contrast(fill, inkOn(fill)));
}

void tst_WidgetParts::nearestSpeedIsShown_data() {
    QTest::addColumn<double>("asked");
    QTest::addColumn<double>("shown");
    QTest::newRow("in the list") << 2.0 << 2.0;
    QTest::newRow("slower than all") << 0.01 << 0.1;
    QTest::newRow("between, nearer to the lower") << 0.3 << 0.25;
    QTest::newRow("by ratio, not by difference") << 1.5 << 2.0;
    QTest::newRow("faster than all") << 1000.0 << 100.0;
    QTest::newRow("as fast as possible") << qInf() << qInf();
    QTest::newRow("zero") << 0.0 << 0.1;
    QTest::newRow("backward") << -1.0 << 0.1;
    QTest::newRow("not a number") << qQNaN() << 0.1;
}

void tst_WidgetParts::nearestSpeedIsShown() {
    QFETCH(double, asked);
    SpeedBox box(nullptr);
    QCOMPARE(box.speed(), 1.0);
    box.setSpeed(asked);
    QTEST(box.speed(), "shown");
}

void tst_WidgetParts::stepsEndAtTheEndsOfTheList() {
    SpeedBox box(nullptr);
    box.step(1);
    QCOMPARE(box.speed(), 2.0);
    box.step(-2);
    QCOMPARE(box.speed(), 0.5);
    box.step(-50);
    QCOMPARE(box.speed(), 0.1);
    box.step(50);
    QCOMPARE(box.speed(), qInf());
    QCOMPARE(box.currentText(), QStringLiteral("max"));
}

void tst_WidgetParts::widgetsKeepTheirOwnKeys_data() {
    QTest::addColumn<QString>("widget");
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("modifiers");
    QTest::addColumn<bool>("own");
    QTest::newRow("slider to its beginning") << "slider" << int(Qt::Key_Home) << 0 << true;
    QTest::newRow("slider to its end") << "slider" << int(Qt::Key_End) << 0 << true;
    QTest::newRow("keypad") << "slider" << int(Qt::Key_Home) << int(Qt::KeypadModifier) << true;
    QTest::newRow("list") << "list" << int(Qt::Key_End) << 0 << true;
    QTest::newRow("choice") << "choice" << int(Qt::Key_Home) << 0 << true;
    QTest::newRow("letter typed into a choice") << "choice" << int(Qt::Key_A) << 0 << true;
    QTest::newRow("digit typed into a choice") << "choice" << int(Qt::Key_2) << 0 << true;
    QTest::newRow("letter with Ctrl") << "choice" << int(Qt::Key_K) << int(Qt::ControlModifier) << false;
    QTest::newRow("letter in a list") << "list" << int(Qt::Key_L) << 0 << false;
    QTest::newRow("a shortcut with Ctrl") << "slider" << int(Qt::Key_Home) << int(Qt::ControlModifier) << false;
    QTest::newRow("another key") << "slider" << int(Qt::Key_F5) << 0 << false;
    QTest::newRow("button without ends") << "button" << int(Qt::Key_Home) << 0 << false;
    QTest::newRow("label") << "label" << int(Qt::Key_End) << 0 << false;
}

void tst_WidgetParts::widgetsKeepTheirOwnKeys() {
    QFETCH(QString, widget);
    QFETCH(int, key);
    QFETCH(int, modifiers);
    QWidget window;
    const std::map<QString, QWidget*> widgets = {{"slider", new QSlider(&window)},
                                                 {"list", new QListWidget(&window)},
                                                 {"choice", new QComboBox(&window)},
                                                 {"button", new QPushButton(&window)},
                                                 {"label", new QLabel(&window)}};
    OwnKeys watch(nullptr);
    const QString text = key < Qt::Key_Escape ? QString(QChar(key)) : QString();
    QKeyEvent asked(QEvent::ShortcutOverride, key, Qt::KeyboardModifiers(modifiers), text);
    asked.ignore();
    QApplication::sendEvent(widgets.at(widget), &asked);
    QTEST(asked.isAccepted(), "own");
}

void tst_WidgetParts::randomChangesOfRobotsAreInOrder() {
    RobotListModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    std::mt19937 random(5);
    std::map<RobotId, RobotRow> expected;
    for (int round = 0; round < 500; ++round) {
        RobotRow row;
        row.id = {1 + static_cast<int>(random() % 8)};
        row.number = 1 + static_cast<int>(random() % 4);
        row.state = QString::number(random() % 3);
        if (random() % 4 == 0) {
            model.removeRobot(row.id);
            expected.erase(row.id);
        } else {
            model.updateRobot(row);
            expected[row.id] = row;
        }
        QCOMPARE(model.rowCount(), static_cast<int>(expected.size()));
        for (int at = 0; at < model.rowCount(); ++at) {
            const RobotRow& shown = model.row(at);
            QVERIFY(shown == expected.at(shown.id));
            QCOMPARE(model.indexOf(shown.id), std::optional(at));
            if (at > 0)
                QVERIFY(std::pair(model.row(at - 1).number, model.row(at - 1).id) < std::pair(shown.number, shown.id));
        }
    }
    QVERIFY(!model.indexOf({99}));
}

USAR_TEST(tst_WidgetParts)

} // namespace tst_widget_parts

#include "tst_widget_parts.moc"
