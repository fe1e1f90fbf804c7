// Layouts of docks: what is written can be read, and a window takes any layout and gives it back.
#include <algorithm>
#include <cmath>
#include <random>

#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMainWindow>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/layout_store.h"
#include "widgets/window/dock_arranger.h"

namespace tst_dock_layout {

using namespace usar;
using namespace usar::widgets;

namespace {

/// Takes little room, so that any split of it is possible.
class SmallWindow : public QMainWindow {
public:
    SmallWindow() {
        setDockOptions(AllowTabbedDocks | AllowNestedDocks);
        setCentralWidget(new QWidget);
        for (int i = 0; i < count; ++i) {
            auto* const dock = new QDockWidget(QString(QChar('A' + i)), this);
            dock->setObjectName(dock->windowTitle());
            dock->setTitleBarWidget(new QWidget); // A title has a least size.
            dock->setWidget(new QWidget);
            addDockWidget(Qt::LeftDockWidgetArea, dock);
        }
        resize(1600, 1200);
        show();
    }
    static constexpr int count = 12;
};

class RandomLayout {
public:
    explicit RandomLayout(unsigned seed) : random_(seed) {
        for (int i = 0; i < SmallWindow::count; ++i)
            free_ << QString(QChar('A' + i));
        std::shuffle(free_.begin(), free_.end(), random_);
    }

    DockLayout make() {
        DockLayout layout;
        layout.name = QString("Ünser %1 / \"%2\"").arg(upTo(100)).arg(QChar(0x2708));
        for (int i = upTo(3); i > 0 && free_.size() > 8; --i)
            layout.floating.push_back({free_.takeLast(), QRect(100 + upTo(99), 100, 200 + upTo(99), 150), upTo(2) > 0});
        std::ranges::sort(layout.floating, {}, &FloatingDock::dock); // As a window lists them.
        layout.views["plots"] = QJsonObject{{"curves", upTo(9)}};
        const QStringList names{"left", "right", "bottom"};
        for (qsizetype i = 0; i < names.size() && !free_.isEmpty(); ++i) {
            const bool last = i + 1 == names.size();
            const auto docks = last ? free_.size() : std::min<qsizetype>(1 + upTo(5), free_.size());
            DockPlace place = split(docks, names[i] == "bottom", 2);
            place.share = 0.0;
            layout.edges[names[i]] = {place, place.open() ? 0.25 + 0.01 * upTo(10) : 0.0};
        }
        return layout;
    }

private:
    int upTo(int most) { return std::uniform_int_distribution<int>(0, most - 1)(random_); }

    DockPlace tabs(qsizetype docks) {
        DockPlace place;
        for (qsizetype i = 0; i < docks; ++i)
            place.tabs << free_.takeLast();
        for (qsizetype i = 1; i < docks; ++i) // Closed ones are listed last.
            if (upTo(4) == 0) {
                place.closed = place.tabs.mid(i);
                break;
            }
        place.front = place.tabs[upTo(static_cast<int>(docks - place.closed.size()))];
        return place;
    }

    DockPlace split(qsizetype docks, bool side_by_side, int depth) {
        if (docks < 2 || depth == 0 || upTo(4) == 0)
            return tabs(docks);
        DockPlace place;
        place.side_by_side = side_by_side;
        const auto here = std::max<qsizetype>(2, std::min<qsizetype>(docks, 2 + upTo(2)));
        double whole = 0.0;
        for (qsizetype i = 0; i < here; ++i) {
            const auto left = docks - (here - 1 - i);
            const auto some = i + 1 == here ? docks : 1 + upTo(static_cast<int>(std::max<qsizetype>(1, left)));
            place.parts.push_back(split(some, !side_by_side, depth - 1));
            place.parts.back().share = 2.0 + upTo(3);
            whole += place.parts.back().share;
            docks -= some;
        }
        for (DockPlace& part : place.parts)
            part.share /= whole;
        return place;
    }

    std::mt19937 random_;
    QStringList free_;
};

/// The difference between two places in words; empty if they are alike, up to `tolerance` of a share.
QString difference(const DockPlace& one, const DockPlace& other, double tolerance) {
    if (one.tabs != other.tabs || one.closed != other.closed || one.front != other.front)
        return QString("tabs %1 | %2 (%3) and %4 | %5 (%6)")
            .arg(one.tabs.join(','), one.closed.join(','), one.front, other.tabs.join(','), other.closed.join(','),
                 other.front);
    if (one.parts.size() != other.parts.size() || (!one.parts.empty() && one.side_by_side != other.side_by_side))
        return QString("%1 and %2 parts of %3")
            .arg(one.parts.size())
            .arg(other.parts.size())
            .arg(one.docks().join(','));
    if (std::abs(one.share - other.share) > tolerance)
        return QString("shares %1 and %2 of %3").arg(one.share).arg(other.share).arg(one.docks().join(','));
    for (std::size_t i = 0; i < one.parts.size(); ++i)
        if (const QString found = difference(one.parts[i], other.parts[i], tolerance); !found.isEmpty())
            return found;
    return {};
}

QString difference(const DockLayout& one, const DockLayout& other, double tolerance) {
    if (one.edges.size() != other.edges.size())
        return "edges";
    for (const auto& [name, edge] : one.edges) {
        const auto found = other.edges.find(name);
        if (found == other.edges.end())
            return name;
        if (std::abs(edge.share - found->second.share) > tolerance)
            return QString("%1 has %2 and %3").arg(name).arg(edge.share).arg(found->second.share);
        if (const QString words = difference(edge.place, found->second.place, tolerance); !words.isEmpty())
            return name + ": " + words;
    }
    return one.floating == other.floating ? QString() : QString("floating docks");
}

constexpr double tenth_of_a_percent = 0.0006;

const QByteArray good_text = R"({"format": "mission-control-layout", "version": 1, "name": "Mine",
    "left": {"size": 0.2, "rows": [{"tabs": ["robots"]}, {"tabs": ["behavior", "world"], "front": "world"}]},
    "unknown": {"ignored": true}})";

/// Left with a part that is written like this.
QByteArray with(const char* part) {
    return QByteArray(R"({"format": "mission-control-layout", "version": 1, "left": )") + part + "}";
}

void damagedRows() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("words");
    QTest::newRow("empty") << QByteArray() << "line 1";
    QTest::newRow("cut off") << good_text.first(100) << "line";
    QTest::newRow("something else") << QByteArray(R"({"robot": "R1"})") << "no layout of the window";
    QTest::newRow("of a newer version") << QByteArray(good_text).replace(R"("version": 1)", R"("version": 2)")
                                        << "newer version of the program";
    QTest::newRow("without a version") << QByteArray(good_text).replace(R"("version": 1, )", "")
                                       << "newer version of the program";
    QTest::newRow("a dock twice") << with(R"({"tabs": ["a", "a"]})") << "the dock 'a' has two places";
    QTest::newRow("a dock without a name") << with(R"({"tabs": [7]})") << "the name of a dock is missing";
    QTest::newRow("a split of one") << with(R"({"rows": [{"tabs": ["a"]}]})") << "needs two parts or more";
    QTest::newRow("a share beyond the whole")
        << with(R"({"rows": [{"tabs": ["a"], "share": 40}, {"tabs": ["b"]}]})") << "left.rows[0].share";
    QTest::newRow("a share in words") << with(R"({"tabs": ["a"], "size": "half"})") << "left.size";
    QTest::newRow("nothing in it") << with(R"({"share": 0.5})") << "neither 'tabs' nor 'rows' nor 'columns'";
    QTest::newRow("another front") << with(R"({"tabs": ["a"], "front": "b"})") << "'b' is not among its tabs";
}

const QByteArray other_docks = R"({"format": "mission-control-layout", "version": 1,
    "left": {"rows": [{"tabs": ["gone"]}, {"tabs": ["A", "older"], "front": "older"}]}})";

} // namespace

class tst_DockLayout : public QObject {
    Q_OBJECT
private slots:
    void whatIsWrittenIsRead() {
        for (unsigned seed = 0; seed < 200; ++seed) {
            const DockLayout layout = RandomLayout(seed).make();
            const auto read = readLayout(layoutText(layout), "file");
            QVERIFY2(read, qPrintable(QString("%1: %2").arg(seed).arg(read ? "" : read.error().text().c_str())));
            const QString found = difference(layout, *read, tenth_of_a_percent);
            QVERIFY2(found.isEmpty(), qPrintable(QString("seed %1: %2").arg(seed).arg(found)));
            QCOMPARE(read->name, layout.name);
            QCOMPARE(read->views, layout.views);
        }
    }

    void aWindowGivesBackTheLayoutThatItTook() {
        SmallWindow window;
        QVERIFY(QTest::qWaitFor([&] { return window.isVisible(); }));
        for (unsigned seed = 0; seed < 60; ++seed) {
            const DockLayout layout = RandomLayout(seed).make();
            arrangeDocks(window, layout);
            QCoreApplication::processEvents();
            const QString found = difference(layout, layoutOf(window), 0.03);
            QVERIFY2(found.isEmpty(), qPrintable(QString("seed %1: %2\n%3\n%4")
                                                     .arg(seed)
                                                     .arg(found, layoutText(layout), layoutText(layoutOf(window)))));
        }
    }

    void whatAPersonWritesIsEnough() {
        const auto layout = readLayout(good_text, "file");
        QVERIFY(layout);
        QCOMPARE(layout->name, QString("Mine"));
        const DockPlace& left = layout->edges.at("left").place;
        QVERIFY(!left.side_by_side);
        QCOMPARE(left.parts[0].share, 0.5);
        QCOMPARE(left.parts[1].front, QString("world"));
    }

    void aDamagedFileGivesOneClearMessage_data() { damagedRows(); }

    void aDamagedFileGivesOneClearMessage() {
        QFETCH(QByteArray, text);
        QFETCH(QString, words);
        const auto layout = readLayout(text, "mine.json");
        QVERIFY(!layout);
        const QString message = QString::fromStdString(layout.error().text());
        QVERIFY2(message.contains(words), qPrintable(message));
        QVERIFY2(message.contains("mine.json"), qPrintable(message));
        QVERIFY(!layout.error().mend.empty());
    }

    void noPrefixOfAFileIsALayout() {
        for (qsizetype size = 0; size < good_text.size(); ++size)
            QVERIFY2(!readLayout(good_text.first(size), "file"), qPrintable(QString::number(size)));
    }

    void docksThatTheWindowLacksAreIgnoredAndNewOnesClosed() {
        SmallWindow window;
        QVERIFY(QTest::qWaitFor([&] { return window.isVisible(); }));
        const auto layout = readLayout(other_docks, "file");
        QVERIFY(layout);
        arrangeDocks(window, *layout);
        for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
            QCOMPARE(dock->isHidden(), dock->objectName() != "A");
    }

    void theFolderHasOneFileForEachLayout() {
        const QTemporaryDir folder;
        const LayoutStore store(folder.path() + "/layouts");
        QVERIFY(store.names().isEmpty());
        DockLayout layout = RandomLayout(3).make();
        for (const char* const name : {"Survey 10", "survey 2", "../outside", "50 %"}) {
            layout.name = name;
            QVERIFY(store.write(layout));
        }
        QCOMPARE(store.names(), (QStringList{"../outside", "50 %", "survey 2", "Survey 10"}));
        QVERIFY(!QFile::exists(folder.path() + "/outside.json"));
        const auto read = store.read("50 %");
        QVERIFY(read);
        QCOMPARE(difference(layout, *read, tenth_of_a_percent), QString());
        QVERIFY(store.remove("50 %"));
        QVERIFY(!store.remove("50 %"));
        QVERIFY(!store.read("50 %"));
    }

    void anImportedLayoutGetsAFreeName() {
        const QTemporaryDir folder;
        const LayoutStore store(folder.path() + "/layouts");
        DockLayout layout = RandomLayout(4).make();
        layout.name = "Mine";
        QVERIFY(store.write(layout));
        const QString elsewhere = folder.path() + "/exported.json";
        QVERIFY(LayoutStore::writeTo(layout, elsewhere));
        const auto imported = store.import(elsewhere);
        QVERIFY(imported);
        QCOMPARE(imported->name, QString("Mine (2)"));
        QVERIFY(!store.import(folder.path() + "/nowhere.json"));
        QVERIFY(!LayoutStore::writeTo(layout, folder.path() + "/no/such/folder.json"));
    }
};

USAR_TEST(tst_DockLayout)

} // namespace tst_dock_layout

#include "tst_dock_layout.moc"
