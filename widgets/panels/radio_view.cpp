#include "widgets/panels/radio_view.h"

#include <QVBoxLayout>

#include "widgets/models/figures.h"
#include "widgets/panels/radio_delegate.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

RadioView::RadioView(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(view_, 1);
    column->addWidget(legend_);
    view_->setModel(model_);
    view_->setItemDelegate(new RadioDelegate(view_));
    view_->setUniformItemSizes(true);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view_->setAccessibleName(tr("Radio links"));
    setFocusProxy(view_);
    legend_->setProperty("role", "muted");
    legend_->setFont(themeFont(FontRole::Small));
    legend_->setContentsMargins(gap::small, gap::tiny, gap::small, gap::tiny);
    legend_->setWordWrap(true);
    legend_->hide();
    empty_state_ = new EmptyState(view_);
    setSource({});
}

void RadioView::take(const std::vector<RadioLink>& links) {
    model_->take(links);
    empty_state_->setVisible(links.empty());
    legend_->setVisible(!links.empty());
}

void RadioView::setSource(const QString& source) {
    const QString meaning = tr("Each bar: one wall more that the link would stand. Dashed: the cut-off, %1 dBm. Lines: "
                               "the last two minutes.")
                                .arg(figure(radio_cutoff_dbm, 0));
    legend_->setText(source.isEmpty() ? meaning : source + QStringLiteral(". ") + meaning);
}

} // namespace usar::widgets
