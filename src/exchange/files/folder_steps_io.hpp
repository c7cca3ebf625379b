#pragma once

#include <sys/stat.h>

#include <set>
#include <string>
#include <string_view>

namespace rubicon::files {

/// The temporary folder within a result folder, and what it is called while it moves in.
inline constexpr std::string_view kInsideStem = ".rubicon-";
inline constexpr std::string_view kStagedName = ".rubicon-new";

/// What a result in a temporary folder has to do with one that is there (ResultFolder's steps).
/// Where they give a number it is an error number, 0 for none.

/// Whether a folder may be replaced by another: nobody but us has it, nothing but plain files is in
/// it, and no mark of it would be lost (its owner, its access list, a mount, being where we are).
bool may_be_exchanged(const std::string& folder);

/// Gives `to`, a new folder, the rights of `from` and a second link to every file of `from` that is
/// not of the `old` result.
int take_over(const std::string& from, const std::string& to, const std::set<std::string>& old);

/// Takes back what take_over linked.
void drop_links(const std::string& from, const std::string& to);

/// Removes a folder with the files of a result, which are no longer of use. What else is in it goes
/// to `home`, if it is not there.
void discard(const std::string& folder, const std::string& home,
             const std::set<std::string>& result);

/// Puts the result in the temporary folder `from` into `folder`, file by file, and removes what the
/// `old` one has beside. From its first step on result_path finds the new one.
int move_in(const std::string& from, const std::string& folder, const std::set<std::string>& old);

/// Removes or completes what ended programs left over beside and in `folder`, but not what belongs
/// to one that is alive.
void clear_left_over(const std::string& folder);

/// While one stands, no other program puts a result into this folder, as far as can be told:
/// somebody else may have locked it for long, and not every file system has locks.
class FolderLock {
 public:
  explicit FolderLock(const std::string& path);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int descriptor_ = -1;
};

/// Locks an open folder for as long as it is open; false where another has it, or nobody can tell.
bool lock_folder(int descriptor);

void sync_folder(const std::string& path);

/// The folder that a path stands in, and its last name.
std::string folder_of(const std::string& path);
std::string name_of(const std::string& path);

}  // namespace rubicon::files
