#include "widgets/models/layout_store.h"

#include <algorithm>

#include <QCollator>
#include <QDir>
#include <QFile>
#include <QSaveFile>
#include <QUrl>

namespace usar::widgets {

namespace {

const QString layout_suffix = QStringLiteral(".json");
constexpr qint64 most_layout_bytes = 1'000'000; ///< a layout has a few thousand

Result<DockLayout> readLayoutFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure("this layout cannot be opened", path.toStdString(),
                       "Check that the file exists and that you may read it");
    if (file.size() > most_layout_bytes)
        return failure("this file is too large for a layout", path.toStdString(),
                       "Choose a file that was saved or exported as a layout");
    return readLayout(file.readAll(), path);
}

} // namespace

QStringList LayoutStore::names() const {
    QStringList names;
    for (const QString& file : QDir(folder_).entryList({"*" + layout_suffix}, QDir::Files | QDir::Hidden))
        names << QUrl::fromPercentEncoding(file.chopped(layout_suffix.size()).toUtf8());
    QCollator order(QLocale::English); // The collation of the "C" locale has no numeric mode.
    order.setNumericMode(true);
    order.setCaseSensitivity(Qt::CaseInsensitive);
    std::ranges::sort(names, [&](const QString& a, const QString& b) { return order.compare(a, b) < 0; });
    return names;
}

QString LayoutStore::fileOf(const QString& name) const {
    return folder_ + "/" + QString::fromLatin1(QUrl::toPercentEncoding(name, " ()")) + layout_suffix;
}

Result<DockLayout> LayoutStore::read(const QString& name) const {
    auto layout = readLayoutFile(fileOf(name));
    if (layout)
        layout->name = name;
    return layout;
}

Result<void> LayoutStore::write(const DockLayout& layout) const {
    QDir().mkpath(folder_);
    return writeTo(layout, fileOf(layout.name));
}

Result<void> LayoutStore::writeTo(const DockLayout& layout, const QString& path) {
    QSaveFile file(path);
    const QByteArray text = layoutText(layout);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
        return failure("the layout cannot be written: " + file.errorString().toStdString(), path.toStdString(),
                       "Choose another place, or make room there");
    return {};
}

Result<void> LayoutStore::remove(const QString& name) const {
    QFile file(fileOf(name));
    if (!file.remove())
        return failure("the layout cannot be deleted: " + file.errorString().toStdString(),
                       file.fileName().toStdString(), "Check that you may write in that folder");
    return {};
}

Result<DockLayout> LayoutStore::import(const QString& path) const {
    auto layout = readLayoutFile(path);
    if (!layout)
        return layout;
    const QString wanted = layout->name.trimmed().isEmpty() ? QStringLiteral("Layout") : layout->name.trimmed();
    const QStringList taken = names();
    layout->name = wanted;
    for (int number = 2; taken.contains(layout->name); ++number)
        layout->name = QStringLiteral("%1 (%2)").arg(wanted).arg(number);
    return layout;
}

} // namespace usar::widgets
