#pragma once

#include <set>
#include <string>
#include <string_view>

namespace rubicon::files {

/// The names in `folder` under which a result of ours stands there, of this version or an earlier
/// one. A name alone says nothing: a file is ours if its first bytes are those that we write, and,
/// where these are only the head of a table or of a picture, if the file that each such result has
/// (its trace, its JSON) stands beside it and is ours. Never a link, nor one of the files `read`,
/// by whatever name or link they are reached.
std::set<std::string> own_names(const std::string& folder, const std::set<std::string>& read);

/// Whether a page, report.html or study.html, is one that we wrote.
bool is_own_page(const std::string& path);

}  // namespace rubicon::files
