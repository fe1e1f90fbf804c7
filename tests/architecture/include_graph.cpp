#include "tests/architecture/include_graph.h"

#include <functional>
#include <set>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

namespace {

QString readAll(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList filesBelow(const QString& root, const QStringList& folders, const QStringList& patterns) {
    QStringList files;
    for (const QString& folder : folders) {
        QDirIterator it(root + '/' + folder, patterns, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext())
            files << QDir(root).relativeFilePath(it.next());
    }
    files.sort();
    return files;
}

} // namespace

std::vector<Include> includesBelow(const QString& root, const QStringList& folders) {
    static const QRegularExpression pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::vector<Include> includes;
    for (const QString& file : filesBelow(root, folders, {"*.h", "*.cpp"})) {
        const QStringList lines = readAll(root + '/' + file).split('\n');
        for (int i = 0; i < lines.size(); ++i) {
            const auto match = pattern.match(lines[i]);
            if (match.hasMatch())
                includes.push_back({file, i + 1, match.captured(2), match.captured(1) == "<"});
        }
    }
    return includes;
}

QString folderOf(const QString& file) {
    const QStringList parts = file.split('/');
    const bool two_deep = parts.size() > 2 && (parts[0] == "core" || parts[0] == "robots");
    return two_deep ? parts[0] + '/' + parts[1] : parts[0];
}

QStringList includeCycle(const std::vector<Include>& includes) {
    std::map<QString, std::set<QString>> targets;
    for (const Include& include : includes)
        if (!include.angled)
            targets[include.file].insert(include.target);
    std::set<QString> done;
    QStringList path;
    const std::function<bool(const QString&)> closes = [&](const QString& file) {
        if (path.contains(file))
            return path = path.mid(path.indexOf(file)), true;
        if (!done.insert(file).second)
            return false;
        path << file;
        for (const QString& target : targets[file])
            if (closes(target))
                return true;
        path.removeLast();
        return false;
    };
    for (const auto& [file, unused] : std::map(targets))
        if (closes(file))
            return path;
    return {};
}

std::map<QString, QStringList> moduleDependencies(const QString& root, const QStringList& folders) {
    static const QRegularExpression module(R"(usar_add_module\(\s*(\w+)([^)]*)\))");
    std::map<QString, QStringList> dependencies;
    for (const QString& file : filesBelow(root, folders, {"CMakeLists.txt"})) {
        auto matches = module.globalMatch(readAll(root + '/' + file));
        while (matches.hasNext()) {
            const auto match = matches.next();
            const QString after = match.captured(2).section("DEPENDS", 1);
            dependencies[match.captured(1)] = after.split(QRegularExpression(R"(\s+)"), Qt::SkipEmptyParts);
        }
    }
    return dependencies;
}
