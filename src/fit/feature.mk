NEEDS_fit := pictures
