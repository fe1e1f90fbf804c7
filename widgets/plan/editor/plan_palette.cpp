#include "widgets/plan/editor/plan_palette.h"

#include <algorithm>

#include <QMimeData>
#include <QShortcut>
#include <QVBoxLayout>

#include "core/posh/model/literal.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int help_role = Qt::UserRole;
constexpr int words_role = Qt::UserRole + 1;
constexpr int sense_role = Qt::UserRole + 2;

QString answerWord(agent::AnswerType type) {
    switch (type) {
    case agent::AnswerType::Boolean:
        return QObject::tr("true or false");
    case agent::AnswerType::Integer:
        return QObject::tr("a whole number");
    case agent::AnswerType::Real:
        return QObject::tr("a number");
    case agent::AnswerType::Text:
        return QObject::tr("a text");
    case agent::AnswerType::Symbol:
        return QObject::tr("a symbol");
    case agent::AnswerType::Any:
        break;
    }
    return QObject::tr("anything");
}

/// A list whose items can be dragged as pieces.
class PieceList : public QTreeWidget {
public:
    explicit PieceList(QWidget* parent) : QTreeWidget(parent) {
        setHeaderHidden(true);
        setRootIsDecorated(true);
        setIndentation(14);
        setDragEnabled(true);
        setDragDropMode(QAbstractItemView::DragOnly);
        setUniformRowHeights(true);
        setIconSize({14, 14});
        setMinimumHeight(80);
    }

protected:
    QStringList mimeTypes() const override { return {QString::fromLatin1(plan_piece_mime_type)}; }
    QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
        return items.isEmpty()
                   ? nullptr
                   : mimeOf({items[0]->data(0, sense_role).toBool(), items[0]->data(0, words_role).toString()});
    }
};

} // namespace

QMimeData* mimeOf(const PlanPiece& piece) {
    auto* data = new QMimeData;
    data->setData(QString::fromLatin1(plan_piece_mime_type),
                  (piece.is_sense ? QStringLiteral("sense ") : QStringLiteral("act ")).toUtf8() + piece.words.toUtf8());
    data->setText(piece.is_sense ? u'(' + piece.words + u')' : piece.words); // For a drop into any text.
    return data;
}

std::optional<PlanPiece> pieceOf(const QMimeData& data) {
    const QString text = QString::fromUtf8(data.data(QString::fromLatin1(plan_piece_mime_type)));
    const QString kind = text.section(u' ', 0, 0);
    if (kind != u"sense" && kind != u"act")
        return std::nullopt;
    return PlanPiece{kind == u"sense", text.section(u' ', 1)};
}

QString helpText(const agent::PrimitiveDescription& primitive) {
    QStringList lines{QString::fromStdString(primitive.help)};
    if (primitive.kind == agent::PrimitiveKind::Sense)
        lines << (primitive.unit.empty()
                      ? QObject::tr("Answers with %1.").arg(answerWord(primitive.answer))
                      : QObject::tr("Answers with %1 in %2.")
                            .arg(answerWord(primitive.answer), QString::fromStdString(primitive.unit)));
    for (const agent::PoshParameter& parameter : primitive.parameters)
        lines << QStringLiteral("$%1=%2: %3%4")
                     .arg(QString::fromStdString(parameter.name),
                          QString::fromStdString(posh::spelled(parameter.default_value)),
                          QString::fromStdString(agent::typeText(parameter)),
                          parameter.help.empty() ? QString()
                                                 : QStringLiteral(". ") + QString::fromStdString(parameter.help));
    if (!primitive.needs.empty()) {
        QStringList needs;
        for (const std::string& need : primitive.needs)
            needs << QString::fromStdString(need);
        lines << QObject::tr("Needs %1.").arg(needs.join(QStringLiteral(", ")));
    }
    lines.removeAll(QString());
    return lines.join(u'\n');
}

QString firstTest(const agent::PrimitiveDescription& sense) {
    const QString name = QString::fromStdString(sense.name);
    switch (sense.answer) {
    case agent::AnswerType::Integer:
        return name + QStringLiteral(" 0 >");
    case agent::AnswerType::Real:
        return name + QStringLiteral(" 0.0 >");
    default:
        return name;
    }
}

PlanPalette::PlanPalette(QWidget* parent)
    : QWidget(parent)
    , search_(makeSearchLine(tr("Find a piece"), tr("Names and descriptions; Return goes to the list"), this))
    , list_(new PieceList(this))
    , help_(new QLabel(this)) {
    setAccessibleName(tr("Pieces"));
    list_->setAccessibleName(tr("Senses, acts and forms"));
    list_->setToolTip(tr("Drag a piece into the drawing; Return or a double-click adds it at the selected part"));
    help_->setWordWrap(true);
    help_->setProperty("role", "muted");
    help_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    help_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    help_->setMinimumHeight(3 * help_->fontMetrics().height());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap::tiny);
    column->addWidget(search_);
    column->addWidget(list_, 1);
    column->addWidget(help_);
    connect(search_, &QLineEdit::textChanged, this, &PlanPalette::applyFilter);
    connect(search_, &QLineEdit::returnPressed, this, [this] { list_->setFocus(Qt::OtherFocusReason); });
    connect(list_, &QTreeWidget::currentItemChanged, this, &PlanPalette::explain);
    connect(list_, &QTreeWidget::itemActivated, this, [this] {
        if (const auto piece = chosen())
            emit pieceRequested(*piece);
    });
    setPrimitives({});
}

void PlanPalette::setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives) {
    senses_.clear();
    acts_.clear();
    for (const agent::PrimitiveDescription& primitive : primitives) {
        const bool is_sense = primitive.kind == agent::PrimitiveKind::Sense;
        const QString name = QString::fromStdString(primitive.name);
        (is_sense ? senses_ : acts_)
            .push_back({name, helpText(primitive), {is_sense, is_sense ? firstTest(primitive) : name}});
    }
    const auto builtIn = [](const QString& name, bool is_sense, const QString& help) {
        return Entry{name, help, {is_sense, name}};
    };
    senses_.push_back(builtIn(QStringLiteral("succeed"), true, tr("Always holds. Every robot has it.")));
    senses_.push_back(builtIn(QStringLiteral("fail"), true, tr("Never holds. Every robot has it.")));
    acts_.push_back(builtIn(QStringLiteral("doNothing"), false, tr("Does nothing, once. Every robot has it.")));
    rebuild();
}

void PlanPalette::setPlan(const posh::Plan& plan) {
    std::vector<Entry> competences;
    std::vector<Entry> patterns;
    std::vector<Entry> adopts;
    for (const posh::Form& form : plan.forms) {
        const QString name = QString::fromStdString(posh::nameOf(form).text);
        if (std::holds_alternative<posh::Competence>(form))
            competences.push_back({name, tr("A competence of this plan."), {false, name}});
        else if (std::holds_alternative<posh::Pattern>(form))
            patterns.push_back({name, tr("An action pattern of this plan."), {false, name}});
        else if (std::holds_alternative<posh::Adopt>(form))
            adopts.push_back({name, tr("An adopt of this plan."), {false, name}});
    }
    const auto same = [](const std::vector<Entry>& a, const std::vector<Entry>& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                          [](const Entry& x, const Entry& y) { return x.name == y.name && x.help == y.help; });
    };
    if (same(competences, competences_) && same(patterns, patterns_) && same(adopts, adopts_))
        return;
    competences_ = std::move(competences);
    patterns_ = std::move(patterns);
    adopts_ = std::move(adopts);
    rebuild();
}

QTreeWidgetItem* PlanPalette::group(const QString& title, const char* icon_name, const std::vector<Entry>& entries) {
    auto* head = new QTreeWidgetItem(list_, {title});
    head->setFlags(Qt::ItemIsEnabled);
    QFont font = list_->font();
    font.setWeight(QFont::DemiBold);
    head->setFont(0, font);
    for (const Entry& entry : entries) {
        auto* item = new QTreeWidgetItem(head, {entry.name});
        item->setData(0, help_role, entry.help);
        item->setData(0, words_role, entry.piece.words);
        item->setData(0, sense_role, entry.piece.is_sense);
        item->setIcon(0, icon(QString::fromLatin1(icon_name)));
        item->setToolTip(0, entry.help);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
    }
    head->setExpanded(true);
    return head;
}

void PlanPalette::rebuild() {
    const auto before = chosen();
    list_->clear();
    group(tr("Senses"), "eye", senses_);
    group(tr("Acts"), "play", acts_);
    if (!competences_.empty())
        group(tr("Competences"), "branches", competences_);
    if (!patterns_.empty())
        group(tr("Action patterns"), "step", patterns_);
    if (!adopts_.empty())
        group(tr("Adopts"), "reset", adopts_);
    applyFilter();
    for (QTreeWidgetItemIterator item(list_); before && *item; ++item)
        if ((*item)->data(0, words_role).toString() == before->words)
            list_->setCurrentItem(*item);
    explain();
    emit wordsChanged();
}

std::vector<PlanWord> PlanPalette::words() const {
    std::vector<PlanWord> all;
    for (const auto* entries : {&senses_, &acts_, &competences_, &patterns_, &adopts_})
        for (const Entry& entry : *entries)
            all.push_back({entry.piece.is_sense, entry.name, entry.help.section(u'\n', 0, 0)});
    std::ranges::sort(all, [](const PlanWord& a, const PlanWord& b) {
        return QString::compare(a.name, b.name, Qt::CaseInsensitive) < 0;
    });
    return all;
}

void PlanPalette::setFilter(const QString& words) {
    search_->setText(words);
}

void PlanPalette::applyFilter() {
    const QStringList words = search_->text().split(u' ', Qt::SkipEmptyParts);
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* const head = list_->topLevelItem(i);
        bool any = false;
        for (int j = 0; j < head->childCount(); ++j) {
            QTreeWidgetItem* const item = head->child(j);
            const QString text = item->text(0) + u' ' + item->data(0, help_role).toString();
            const bool fits = std::ranges::all_of(
                words, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
            item->setHidden(!fits);
            any = any || fits;
        }
        head->setHidden(!any);
    }
}

std::optional<PlanPiece> PlanPalette::chosen() const {
    const QTreeWidgetItem* const item = list_->currentItem();
    if (!item || item->data(0, words_role).isNull())
        return std::nullopt;
    return PlanPiece{item->data(0, sense_role).toBool(), item->data(0, words_role).toString()};
}

void PlanPalette::explain() {
    const QTreeWidgetItem* const item = list_->currentItem();
    const QString help = item ? item->data(0, help_role).toString() : QString();
    help_->setText(help.isEmpty() ? tr("Drag pieces into the drawing.") : help);
}

} // namespace usar::widgets
