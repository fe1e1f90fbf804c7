#include "widgets/models/sensor_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QMimeData>
#include <QSize>

#include "core/protocol/silence.h"
#include "widgets/models/figures.h"
#include "widgets/models/parameter_display.h"
#include "widgets/models/row_model.h"
#include "widgets/models/series_store.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

/// Sort key of the first answer; larger than the number of streams can ever be.
constexpr int answers_from = 1'000'000;

template <class Type, class... Others>
constexpr bool isOneOf = (std::is_same_v<Type, Others> || ...);

/// True for answers to a question; all other messages are repeated.
bool isAnswer(const protocol::InfoMessage& message) {
    if (const auto* generic = std::get_if<protocol::GenericMessage>(&message))
        return generic->type_word == "NFO" || generic->type_word == "GEO" || generic->type_word == "CONF" ||
               generic->type_word == "RES";
    return std::visit(
        []<class Message>(const Message&) {
            return isOneOf<Message, protocol::GameInfo, protocol::StartPoses, protocol::LockstepInfo,
                           protocol::GeometryInfo, protocol::ConfigurationInfo, protocol::Response>;
        },
        message);
}

int decimalsOf(double shown, const QString& unit) {
    if (unit == u"°" || unit == u"s" || unit == u"%")
        return 1;
    return unit.isEmpty() ? (shown == std::round(shown) ? 0 : 3) : 2;
}

struct NameOf {
    std::string operator()(const protocol::GenericMessage& m) const {
        return m.type_word + ' ' + m.type + ' ' + m.name;
    }
    std::string operator()(const protocol::PackageState& m) const { return m.name; }
    std::string operator()(const protocol::EffecterState& m) const { return m.type + ' ' + m.name; }
    /// Type and first name, because all sensors of a group always arrive together.
    template <protocol::SensorMessage Sensor>
    std::string operator()(const Sensor& m) const {
        std::string stream(protocol::wireTypeOf(m));
        bool first = true;
        protocol::forEachReading(m, [&](const std::string& name, const auto&) {
            if (std::exchange(first, false))
                (stream += ' ') += name;
        });
        return stream;
    }
    std::string operator()(const protocol::GeometryInfo& m) const { return withFirst(m); }
    std::string operator()(const protocol::ConfigurationInfo& m) const { return withFirst(m); }
    std::string operator()(const protocol::Response& m) const { return m.type + ' ' + m.name; }
    std::string operator()(const auto&) const { return {}; }

private:
    static std::string withFirst(const auto& m) {
        return m.type + ' ' + (m.items.empty() ? std::string() : m.items.front().name);
    }
};

} // namespace

void SensorModel::Timing::arrived(Seconds now, int count) {
    // The smoothed period follows a changed rate within a few messages, but not a single late message.
    if (now > last && last.count() > 0.0) {
        const Seconds newest = (now - last) / std::max(1, count);
        period = period ? 0.7 * *period + 0.3 * newest : newest;
    }
    last = now;
}

bool SensorModel::Timing::stale(Seconds now, bool linked) const {
    if (!repeats)
        return false;
    return !linked || now - last > std::max(3.0 * period.value_or(Seconds(0.0)), protocol::silence::reading);
}

QString SensorModel::Source::title() const {
    const QString kind = name.startsWith(u"SEN ") ? name.mid(4) : name;
    const QString item = leaves.empty() || !single ? QString() : QString::fromStdString(leaves.front().field.item);
    return item.isEmpty() || item == kind ? kind : kind + QStringLiteral("  ") + item;
}

void SensorModel::take(const protocol::InfoLine& line, Seconds now, int count) {
    const bool repeats = !isAnswer(line.message);
    Source* source = nullptr;
    for (const protocol::Field& field : protocol::fieldsOf(line.message)) {
        if (!source || source->name != QString::fromStdString(field.source)) {
            source = &sourceNamed(field.source, repeats);
            source->timing.arrived(now, count);
        }
        takeField(*source, field, now, count, repeats);
    }
}

SensorModel::Source& SensorModel::sourceNamed(const std::string& name, bool repeats) {
    const auto [row, is_new] = source_rows_.try_emplace(name, sources_.size());
    if (is_new) {
        const int at = static_cast<int>(sources_.size());
        beginInsertRows({}, at, at);
        sources_.push_back({QString::fromStdString(name), {}, {}, true});
        sources_.back().timing.repeats = repeats; // Before views see the row, because they sort by it.
        endInsertRows();
    }
    return sources_[row->second];
}

void SensorModel::takeField(Source& source, const protocol::Field& field, Seconds now, int count, bool repeats) {
    const auto [row, is_new] = leaf_rows_.try_emplace(field.path(), source.leaves.size());
    if (is_new) {
        const int at = static_cast<int>(source.leaves.size());
        beginInsertRows(index(static_cast<int>(&source - sources_.data()), 0), at, at);
        source.leaves.emplace_back();
        endInsertRows();
    }
    Leaf& leaf = source.leaves[row->second];
    leaf.field = field;
    source.single = source.single && field.item == source.leaves.front().field.item;
    leaf.timing.repeats = repeats;
    leaf.timing.arrived(now, count);
    if (field.number) {
        const DisplayUnit unit = displayUnit(field.unit);
        leaf.decimals = std::max(leaf.decimals, decimalsOf(*field.number * unit.factor, unit.text));
    }
}

void SensorModel::flush(Seconds now, bool linked) {
    now_ = now;
    linked_ = linked;
    if (sources_.empty())
        return;
    emit dataChanged(index(0, Age), index(rowCount() - 1, Rate));
    for (int row = 0; row < rowCount(); ++row) {
        const QModelIndex source = index(row, 0);
        if (const int leaves = rowCount(source); leaves > 0)
            emit dataChanged(index(0, Value, source), index(leaves - 1, Rate, source));
    }
}

void SensorModel::clear() {
    beginResetModel();
    sources_.clear();
    source_rows_.clear();
    leaf_rows_.clear();
    endResetModel();
}

QStringList SensorModel::types() const {
    QStringList types;
    for (const Source& source : sources_)
        types << source.name;
    return types;
}

QModelIndex SensorModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? quintptr(parent.row() + 1) : quintptr(0));
}

QModelIndex SensorModel::parent(const QModelIndex& child) const {
    if (!child.isValid() || child.internalId() == 0)
        return {};
    return createIndex(static_cast<int>(child.internalId()) - 1, 0, quintptr(0));
}

int SensorModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid())
        return static_cast<int>(sources_.size());
    if (parent.internalId() != 0 || parent.column() != 0)
        return 0;
    return static_cast<int>(sources_[static_cast<std::size_t>(parent.row())].leaves.size());
}

const SensorModel::Leaf* SensorModel::leafAt(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == 0)
        return nullptr;
    return &sources_[index.internalId() - 1].leaves[static_cast<std::size_t>(index.row())];
}

const SensorModel::Timing& SensorModel::timingAt(const QModelIndex& index) const {
    const Leaf* leaf = leafAt(index);
    return leaf ? leaf->timing : sources_[static_cast<std::size_t>(index.row())].timing;
}

QString SensorModel::valueText(const Leaf& leaf) const {
    if (!leaf.field.number)
        return QString::fromStdString(leaf.field.text);
    return figure(*leaf.field.number * displayUnit(leaf.field.unit).factor, leaf.decimals);
}

QVariant SensorModel::text(const QModelIndex& index) const {
    const Leaf* leaf = leafAt(index);
    const Timing& timing = timingAt(index);
    switch (index.column()) {
    case Name: {
        if (!leaf)
            return sources_[static_cast<std::size_t>(index.row())].title();
        const QString item = QString::fromStdString(leaf->field.item);
        return item.isEmpty() || sources_[static_cast<std::size_t>(index.parent().row())].single
                   ? QString::fromStdString(leaf->field.field)
                   : item + QStringLiteral("  ") + QString::fromStdString(leaf->field.field);
    }
    case Value:
        return leaf ? valueText(*leaf) : QString();
    case Unit:
        return leaf && leaf->field.number ? displayUnit(leaf->field.unit).text : QString();
    case Age:
        return timing.repeats ? ageText(now_ - timing.last) : tr("answer");
    case Rate:
        return timing.period && timing.period->count() > 0.0
                   ? figure(1.0 / timing.period->count(), 1) + QStringLiteral(" Hz")
                   : QString();
    default:
        return {};
    }
}

QVariant SensorModel::look(const QModelIndex& index, int role) const {
    const bool stale = timingAt(index).stale(now_, linked_);
    const bool is_value = index.column() == Value;
    if (role == Qt::ForegroundRole)
        return stale ? tokens().stale : is_value || index.column() == Name ? tokens().text : tokens().text_muted;
    QFont font = themeFont(FontRole::Body, leafAt(index) || index.column() != Name ? QFont::Normal : QFont::DemiBold);
    font.setStrikeOut(stale && is_value);
    return font;
}

QVariant SensorModel::data(const QModelIndex& index, int role) const {
    const Leaf* leaf = leafAt(index);
    switch (role) {
    case Qt::DisplayRole:
        return text(index);
    case Qt::ForegroundRole:
    case Qt::FontRole:
        return look(index, role);
    case Qt::TextAlignmentRole:
        return headerData(index.column(), Qt::Horizontal, role);
    case Qt::ToolTipRole:
        if (!leaf)
            return tr("%1: age of its newest message, and messages per second")
                .arg(text(index.siblingAtColumn(Name)).toString());
        return QString::fromStdString(leaf->field.path()) + QStringLiteral(" = ") + valueText(*leaf) +
               QStringLiteral("\n") +
               (leaf->field.number ? tr("Double-click or drag to the plots") : tr("A text: it cannot be plotted"));
    case Qt::AccessibleDescriptionRole:
        return timingAt(index).stale(now_, linked_) ? tr("out of date") : QString();
    case Qt::SizeHintRole:
        return QSize(0, minimum_target);
    case PathRole:
        return leaf ? QString::fromStdString(leaf->field.path()) : QString();
    case UnitRole:
        return leaf ? QString::fromStdString(leaf->field.unit) : QString();
    case SortRole:
        return leaf ? index.row() : index.row() + (timingAt(index).repeats ? 0 : answers_from);
    case NumericRole:
        return leaf && leaf->field.number.has_value();
    default:
        return {};
    }
}

QVariant SensorModel::headerData(int section, Qt::Orientation orientation, int role) const {
    const QString titles[] = {tr("Sensor"), tr("Value"), QString(), tr("Age"), tr("Rate")};
    return columnHead(orientation, role, titles[section],
                      section == Name || section == Unit ? Qt::AlignLeft : Qt::AlignRight);
}

Qt::ItemFlags SensorModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractItemModel::flags(index);
    return data(index, NumericRole).toBool() ? flags | Qt::ItemIsDragEnabled : flags;
}

QStringList SensorModel::mimeTypes() const {
    return {QString::fromLatin1(field_mime_type)};
}

QMimeData* SensorModel::mimeData(const QModelIndexList& indexes) const {
    QStringList paths;
    for (const QModelIndex& index : indexes)
        if (const QString path = data(index, PathRole).toString();
            data(index, NumericRole).toBool() && !paths.contains(path))
            paths << path;
    if (paths.isEmpty())
        return nullptr;
    auto* mime = new QMimeData;
    mime->setData(mimeTypes().front(), paths.join(u'\n').toUtf8());
    return mime;
}

std::vector<SensorModel::Number> SensorModel::numbers() const {
    std::vector<Number> numbers;
    for (int source = 0; source < rowCount(); ++source) {
        const QModelIndex parent = index(source, 0);
        for (int leaf = 0; leaf < rowCount(parent); ++leaf)
            if (const QModelIndex field = index(leaf, 0, parent); field.data(NumericRole).toBool())
                numbers.push_back({field.data(PathRole).toString(), field.data(UnitRole).toString()});
    }
    return numbers;
}

std::string streamOf(const protocol::InfoMessage& message) {
    return std::to_string(message.index()) + ' ' + std::visit(NameOf{}, message);
}

void NewestLines::take(const protocol::InfoLine& line, Seconds now) {
    const auto [place, is_new] = places_.try_emplace(streamOf(line.message), lines_.size());
    if (is_new)
        lines_.emplace_back();
    CountedLine& counted = lines_[place->second];
    counted.line = line;
    counted.now = now;
    ++counted.count;
}

std::vector<CountedLine> NewestLines::takeAll() {
    places_.clear();
    return std::exchange(lines_, {});
}

} // namespace usar::widgets
