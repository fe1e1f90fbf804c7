#include "widgets/models/dock_layout.h"

#include <algorithm>
#include <cmath>

#include <QJsonArray>
#include <QJsonDocument>

namespace usar::widgets {

namespace {

const QString layout_format = QStringLiteral("mission-control-layout");
constexpr int newest_layout_version = 1;
const QStringList layout_edge_names{"left", "right", "top", "bottom"};

double roundedShare(double share) {
    return std::round(share * 1000.0) / 1000.0;
}

QJsonObject placeJson(const DockPlace& place) {
    QJsonObject json;
    if (place.parts.empty()) {
        json["tabs"] = QJsonArray::fromStringList(place.tabs);
        if (!place.front.isEmpty())
            json["front"] = place.front;
        if (!place.closed.isEmpty())
            json["closed"] = QJsonArray::fromStringList(place.closed);
    } else {
        QJsonArray parts;
        for (const DockPlace& part : place.parts)
            parts.append(placeJson(part));
        json[place.side_by_side ? "columns" : "rows"] = parts;
    }
    if (place.share > 0.0)
        json["share"] = roundedShare(place.share);
    return json;
}

/// Reads the parts of a layout and remembers what was wrong first.
class LayoutReader {
public:
    explicit LayoutReader(const QString& file) : file_(file) {}

    Result<DockLayout> read(const QByteArray& text) {
        QJsonParseError error;
        const QJsonDocument document = QJsonDocument::fromJson(text, &error);
        if (error.error != QJsonParseError::NoError)
            return damaged(QStringLiteral("line %1").arg(text.left(error.offset).count('\n') + 1), error.errorString());
        const QJsonObject json = document.object();
        if (json["format"].toString() != layout_format)
            return failure("this file is no layout of the window", file_.toStdString(),
                           "Choose a file that was saved or exported as a layout");
        if (json["version"].toInt(newest_layout_version + 1) > newest_layout_version)
            return failure("this layout was written by a newer version of the program", file_.toStdString(),
                           "Use that version, or save the layout again with this one");
        DockLayout layout{json["name"].toString(), {}, {}, json["views"].toObject()};
        for (const QString& edge : layout_edge_names)
            if (const QJsonObject docks = json[edge].toObject(); !docks.isEmpty())
                layout.edges[edge] = {placeOf(docks, edge), shareOf(docks["size"], edge + ".size")};
        for (const auto& one : json["floating"].toArray())
            layout.floating.push_back(floatingOf(one.toObject()));
        if (!trouble_.isEmpty())
            return damaged(where_, trouble_);
        return layout;
    }

private:
    tl::unexpected<Error> damaged(const QString& where, const QString& why) const {
        return failure(QStringLiteral("this layout cannot be read: %1").arg(why).toStdString(),
                       QStringLiteral("%1, %2").arg(file_, where).toStdString(),
                       "Correct the file, or delete it and save the layout again");
    }
    void complain(const QString& where, const QString& why) {
        if (!trouble_.isEmpty())
            return;
        trouble_ = why;
        where_ = where;
    }
    /// Remembers that the dock has a place.
    QString dockOf(const QJsonValue& value, const QString& where) {
        const QString dock = value.toString();
        if (dock.isEmpty())
            complain(where, QStringLiteral("the name of a dock is missing"));
        else if (placed_.contains(dock))
            complain(where, QStringLiteral("the dock '%1' has two places").arg(dock));
        placed_ << dock;
        return dock;
    }
    double shareOf(const QJsonValue& value, const QString& where) {
        const double share = value.toDouble(value.isUndefined() ? 0.0 : -1.0);
        if (share < 0.0 || share > 1.0)
            complain(where, QStringLiteral("a share is a number from 0 to 1"));
        return share;
    }

    DockPlace placeOf(const QJsonObject& json, const QString& where) {
        DockPlace place;
        place.share = shareOf(json["share"], where + ".share");
        place.side_by_side = json.contains("columns");
        const QString key = place.side_by_side ? QStringLiteral("columns") : QStringLiteral("rows");
        if (json.contains(key)) {
            const QJsonArray parts = json[key].toArray();
            for (qsizetype i = 0; i < parts.size(); ++i)
                place.parts.push_back(placeOf(parts[i].toObject(), QStringLiteral("%1.%2[%3]").arg(where, key).arg(i)));
            if (place.parts.size() < 2)
                complain(where, QStringLiteral("'%1' needs two parts or more").arg(key));
            fillShares(place);
            return place;
        }
        for (const auto& tab : json["tabs"].toArray())
            place.tabs << dockOf(tab, where + ".tabs");
        if (place.tabs.isEmpty())
            complain(where, QStringLiteral("it has neither 'tabs' nor 'rows' nor 'columns'"));
        for (const auto& tab : json["closed"].toArray())
            place.closed << tab.toString();
        place.front = json["front"].toString();
        for (const QString& tab : place.closed + (place.front.isEmpty() ? QStringList() : QStringList(place.front)))
            if (!place.tabs.contains(tab))
                complain(where, QStringLiteral("'%1' is not among its tabs").arg(tab));
        return place;
    }

    /// Parts that are open and have no share get an even one.
    static void fillShares(DockPlace& place) {
        for (DockPlace& part : place.parts)
            if (part.open() && part.share <= 0.0)
                part.share = 1.0 / static_cast<double>(place.parts.size());
    }

    FloatingDock floatingOf(const QJsonObject& json) {
        const QRect at(json["x"].toInt(), json["y"].toInt(), json["width"].toInt(), json["height"].toInt());
        if (at.isEmpty())
            complain(QStringLiteral("floating"), QStringLiteral("a floating dock has no size"));
        return {dockOf(json["dock"], QStringLiteral("floating")), at, json["open"].toBool(true)};
    }

    QString file_;
    QString where_;
    QString trouble_;
    QStringList placed_;
};

} // namespace

bool DockPlace::open() const {
    return parts.empty() ? closed.size() < tabs.size() : std::ranges::any_of(parts, &DockPlace::open);
}

QStringList DockPlace::docks() const {
    QStringList all = tabs;
    for (const DockPlace& part : parts)
        all << part.docks();
    return all;
}

QByteArray layoutText(const DockLayout& layout) {
    QJsonObject json{{"format", layout_format}, {"version", newest_layout_version}, {"name", layout.name}};
    for (const auto& [name, edge] : layout.edges) {
        QJsonObject docks = placeJson(edge.place);
        if (edge.share > 0.0)
            docks["size"] = roundedShare(edge.share);
        json[name] = docks;
    }
    QJsonArray floating;
    for (const FloatingDock& one : layout.floating)
        floating.append(QJsonObject{{"dock", one.dock},
                                    {"x", one.geometry.x()},
                                    {"y", one.geometry.y()},
                                    {"width", one.geometry.width()},
                                    {"height", one.geometry.height()},
                                    {"open", one.open}});
    if (!floating.isEmpty())
        json["floating"] = floating;
    if (!layout.views.isEmpty())
        json["views"] = layout.views;
    return QJsonDocument(json).toJson();
}

Result<DockLayout> readLayout(const QByteArray& text, const QString& file) {
    return LayoutReader(file).read(text);
}

} // namespace usar::widgets
