"""Problems of reading a description: errors of XML and of xacro."""
