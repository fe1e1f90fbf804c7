// The table "who may include whom" of the house, read from the code at each run.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QTest>

#include "tests/architecture/include_graph.h"
#include "tests/suite/suite.h"

namespace tst_layering {

namespace {

const QString root = USAR_SOURCE_DIR;
const QStringList code_folders{"app", "core", "widgets", "robots"};

struct Rule {
    QStringList ours; ///< folders that may be included besides the own one
    QStringList qt;   ///< Qt modules
};

const QStringList sdk{"core/base", "core/protocol", "core/modules", "core/posh", "core/mapping"};

const std::map<QString, Rule> rules{
    {"core/base", {{}, {}}},
    {"core/usage", {{"core/base"}, {"QtCore"}}},
    {"core/protocol", {{"core/base"}, {}}},
    {"core/posh", {{"core/base"}, {}}},
    {"core/mapping", {{"core/base"}, {}}},
    {"core/modules", {{"core/base", "core/protocol"}, {}}},
    {"core/sim", {{"core/base", "core/protocol"}, {}}},
    {"core/agent", {sdk, {"QtCore"}}},
    {"core/link", {{"core/base", "core/protocol"}, {"QtCore", "QtNetwork"}}},
    {"core/server",
     {{"core/base", "core/usage", "core/protocol", "core/link", "core/sim"}, {"QtCore", "QtGui", "QtNetwork"}}},
    {"core/mission", {sdk + QStringList{"core/usage", "core/agent", "core/link"}, {"QtCore", "QtGui", "QtNetwork"}}},
    {"core/campaign", {{"core/base", "core/usage", "core/mission"}, {"QtCore"}}},
    {"robots", {sdk + QStringList{"core/agent"}, {"QtCore"}}},
    {"widgets", {sdk + QStringList{"core/agent"}, {"QtCore", "QtGui", "QtWidgets", "QtPrintSupport", "QtDBus"}}},
};

/// Rooms that use no Qt although their folder may.
const QStringList rooms_without_qt{"core/campaign/statistics"};

/// The rooms within a folder, and which of its other rooms each may include; "" is the folder itself.
const std::map<QString, std::map<QString, QStringList>> rooms{
    {"core/posh",
     {{"model", {}},
      {"language", {"model"}},
      {"edit", {"model", "language"}},
      {"run", {"model", "language"}},
      {"trace", {"model", "language", "run"}}}},
    {"core/mission",
     {{"files", {}},
      {"commands", {}},
      {"hand", {"commands"}},
      {"claims", {"files"}},
      {"session", {"commands", "hand", "files", "claims"}},
      {"runs", {"session", "files", "claims"}},
      {"edits", {"files"}},
      {"world", {"session", "edits"}},
      {"fleet", {"runs", "world", "session", "files"}},
      {"reports", {"runs", "session", "files"}}}},
    {"core/campaign",
     {{"statistics", {}}, {"plan", {}}, {"runs", {"plan"}}, {"comparison", {"statistics", "plan", "runs"}}}},
    {"widgets",
     {{"style", {}},
      {"models", {"style"}},
      {"commands", {"style", "models"}},
      {"drive", {"style", "models"}},
      {"panels", {"style", "models"}},
      {"bars", {"style", "models"}},
      {"messages", {"style", "models"}},
      {"map", {"style", "models", "panels"}},
      {"relief", {"style", "models", "map"}},
      {"campaign", {"style", "models", "panels"}},
      {"plan", {"style", "models", "messages", "panels"}},
      {"window",
       {"style", "models", "commands", "drive", "panels", "bars", "messages", "map", "relief", "plan", "campaign"}}}},
    {"app", {{"host", {}}, {"cli", {"host"}}, {"desks", {"host"}}, {"window", {"host", "desks"}}}},
};

/// "posh" folder's "run" for "core/posh/run/engine.h"; empty for a file of the folder itself.
QString roomOf(const QString& file) {
    const QString within = file.mid(folderOf(file).size() + 1);
    return within.contains('/') ? within.section('/', 0, 0) : QString();
}

const Rule* ruleFor(const QString& folder) {
    const auto rule = rules.find(folder.startsWith("robots/") ? QString("robots") : folder);
    return rule == rules.end() ? nullptr : &rule->second;
}

/// "QtCore" for <QString>; empty for a header that is not Qt's.
QString qtModuleOf(const QString& header) {
    const QString headers = QLibraryInfo::path(QLibraryInfo::HeadersPath);
    for (const QString& module : QDir(headers).entryList({"Qt*"}, QDir::Dirs))
        if (header.startsWith(module + '/') || QFile::exists(headers + '/' + module + '/' + header))
            return module;
    return {};
}

/// Made by Qt's moc in the build folder.
bool isGenerated(const Include& include) {
    return include.target.endsWith(".moc") || include.target.startsWith("moc_");
}

/// The sample is to be copied elsewhere, so its files name each other without the way to them.
bool isOfTheSample(const Include& include) {
    return include.file.startsWith("robots/sample/") && QFile::exists(root + "/robots/sample/" + include.target);
}

/// What is wrong with one #include, or nothing.
QString complaint(const Include& include) {
    if (isGenerated(include) || isOfTheSample(include))
        return {};
    const QString folder = folderOf(include.file);
    const Rule* rule = ruleFor(folder);
    if (!rule)
        return folder == "app" ? QString() : folder + " has no row in the table";
    if (include.angled) {
        const QString module = qtModuleOf(include.target);
        const bool allowed = rule->qt.contains(module) && !rooms_without_qt.contains(QFileInfo(include.file).path());
        return module.isEmpty() || allowed ? QString() : folder + " may not use " + module;
    }
    const QString target = folderOf(include.target);
    return target == folder || rule->ours.contains(target) ? QString() : folder + " may not include " + target;
}

/// What is wrong with one #include from one room of a folder to another, or nothing.
QString roomComplaint(const Include& include) {
    const QString folder = folderOf(include.file);
    const auto house = rooms.find(folder);
    if (include.angled || isGenerated(include) || house == rooms.end() || folderOf(include.target) != folder)
        return {};
    const QString from = roomOf(include.file), to = roomOf(include.target);
    const auto rule = house->second.find(from);
    if (rule == house->second.end())
        return QString("%1/%2 has no row among the rooms").arg(folder, from);
    return from == to || rule->second.contains(to) ? QString()
                                                   : QString("%1/%2 may not include %1/%3").arg(folder, from, to);
}

} // namespace

class tst_Layering : public QObject {
    Q_OBJECT
private slots:
    void noArrowLeavesTheTable();
    void includesAreWrittenFromTheRoot();
    void noIncludeCycles();
    void targetsLinkOnlyWhatTheTableAllows();
    void theTestItselfSeesAForbiddenArrow();
};

void tst_Layering::noArrowLeavesTheTable() {
    const auto includes = includesBelow(root, code_folders);
    QVERIFY(includes.size() > 100);
    QStringList complaints;
    for (const Include& include : includes) {
        for (const QString& text : {complaint(include), roomComplaint(include)})
            if (!text.isEmpty())
                complaints << QString("%1:%2: %3").arg(include.file).arg(include.line).arg(text);
    }
    QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join('\n')));
}

void tst_Layering::includesAreWrittenFromTheRoot() {
    for (const Include& include : includesBelow(root, code_folders)) {
        if (include.angled || isGenerated(include) || isOfTheSample(include))
            continue;
        QVERIFY2(QFile::exists(root + '/' + include.target),
                 qPrintable(QString("%1:%2: \"%3\"").arg(include.file).arg(include.line).arg(include.target)));
    }
}

void tst_Layering::noIncludeCycles() {
    const QStringList cycle = includeCycle(includesBelow(root, code_folders));
    QVERIFY2(cycle.isEmpty(), qPrintable(cycle.join(" -> ")));
}

void tst_Layering::targetsLinkOnlyWhatTheTableAllows() {
    const auto modules = moduleDependencies(root, {"core", "widgets"});
    QVERIFY(modules.size() >= 8);
    for (const auto& [module, dependencies] : modules) {
        const Rule* rule = ruleFor(module == "widgets" ? module : "core/" + module);
        QVERIFY2(rule, qPrintable(module));
        for (const QString& dependency : dependencies) {
            if (!dependency.startsWith("usar::"))
                continue;
            const QString target = "core/" + dependency.mid(6);
            QVERIFY2(rule->ours.contains(target), qPrintable(module + " may not link " + target));
        }
    }
}

void tst_Layering::theTestItselfSeesAForbiddenArrow() {
    QVERIFY(!complaint({"robots/airrobot/a.cpp", 1, "core/sim/world.h", false}).isEmpty());
    QVERIFY(!complaint({"robots/airrobot/a.cpp", 1, "robots/p2dx/b.h", false}).isEmpty());
    QVERIFY(!complaint({"core/base/a.h", 1, "QString", true}).isEmpty());
    QVERIFY(!complaint({"core/agent/a.h", 1, "QWidget", true}).isEmpty());
    QVERIFY(!complaint({"widgets/a.h", 1, "core/mission/robot_session.h", false}).isEmpty());
    QVERIFY(!complaint({"core/link/a.h", 1, "core/sim/simulation.h", false}).isEmpty());
    QVERIFY(!complaint({"core/mission/session/a.h", 1, "core/server/simulator_server.h", false}).isEmpty());
    QVERIFY(!complaint({"core/campaign/statistics/a.h", 1, "QString", true}).isEmpty());
    QVERIFY(complaint({"core/campaign/comparison/a.h", 1, "QString", true}).isEmpty());
    QVERIFY(complaint({"core/server/a.h", 1, "core/sim/simulation.h", false}).isEmpty());
    QVERIFY(!roomComplaint({"core/posh/run/a.h", 1, "core/posh/edit/b.h", false}).isEmpty());
    QVERIFY(roomComplaint({"core/posh/run/a.h", 1, "core/posh/language/b.h", false}).isEmpty());
    QCOMPARE(includeCycle({{"a.h", 1, "b.h", false}, {"b.h", 1, "a.h", false}}).size(), 2);
}

USAR_TEST(tst_Layering)

} // namespace tst_layering

#include "tst_layering.moc"
